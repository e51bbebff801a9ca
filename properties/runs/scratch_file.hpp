// A file that only this process uses and that goes when it is no longer needed.
#pragma once

#include <string>

namespace tps::properties::runs {

class ScratchFile {
 public:
  /// A new, empty file in the system's directory for such. Throws std::runtime_error where there is none.
  ScratchFile();
  explicit ScratchFile(const std::string& content);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }
  std::string content() const;

 private:
  std::string path_;
};

}  // namespace tps::properties::runs
