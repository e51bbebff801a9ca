// A file that only this process uses and that goes when it is no longer needed.
#pragma once

#include <string>

namespace tps {

class ScratchFile {
 public:
  /// A new, empty file in $TMPDIR, else in /tmp. Throws OutputError where there can be none.
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

}  // namespace tps
