#include "reference/text/scratch_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "reference/text/output.hpp"

namespace tps {

ScratchFile::ScratchFile() {
  const char* named = std::getenv("TMPDIR");
  const std::string folder = named != nullptr && *named != '\0' ? named : "/tmp";
  path_ = folder + "/tps-XXXXXX";
  const int descriptor = ::mkstemp(path_.data());
  if (descriptor < 0)
    throw OutputError(folder +
                      ": a temporary file cannot be made there: " + std::generic_category().message(errno) +
                      "; set TMPDIR to a folder that can be written");
  ::close(descriptor);
}

ScratchFile::ScratchFile(const std::string& content) : ScratchFile() {
  std::ofstream(path_, std::ios::binary) << content;
}

ScratchFile::~ScratchFile() {
  ::unlink(path_.c_str());
}

std::string ScratchFile::content() const {
  std::ostringstream bytes;
  bytes << std::ifstream(path_, std::ios::binary).rdbuf();
  return std::move(bytes).str();
}

}  // namespace tps
