#include "properties/runs/scratch_file.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tps::properties::runs {

ScratchFile::ScratchFile() {
  const std::string pattern = (std::filesystem::temp_directory_path() / "tps_run_XXXXXX").string();
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  const int file = mkstemp(name.data());
  if (file < 0) throw std::runtime_error("no file like " + pattern + " can be created");
  close(file);
  path_ = name.data();
}

ScratchFile::ScratchFile(const std::string& content) : ScratchFile() {
  std::ofstream(path_, std::ios::binary) << content;
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

std::string ScratchFile::content() const {
  std::ostringstream bytes;
  bytes << std::ifstream(path_, std::ios::binary).rdbuf();
  return std::move(bytes).str();
}

}  // namespace tps::properties::runs
