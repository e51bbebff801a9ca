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
  const char* folder = std::getenv("TMPDIR");
  path_ = std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/tps-XXXXXX";
  const int descriptor = ::mkstemp(path_.data());
  if (descriptor < 0)
    throw OutputError(path_ + ": a temporary file cannot be made: " + std::generic_category().message(errno));
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
