// The files of one call: what is written is nothing else of it.
#pragma once

#include <string>
#include <vector>

namespace tps::cli {

/// Files by the options that name them. Two names are one file if they lead to it, through links or not, and
/// whether or not it is there yet; standard input, output and error count where they are files. Devices may
/// be named as often as one likes.
class NamedFiles {
 public:
  /// "-" is standard input and output; an empty path is none.
  NamedFiles& reads(const std::string& option, const std::string& path);
  NamedFiles& writes(const std::string& option, const std::string& path);

  /// To be called before anything is opened for writing. Throws CLI::ValidationError that names the two.
  void require_distinct() const;

 private:
  struct File {
    std::string option, path;
    bool written = false;
    bool stream = false;  ///< a standard one: any two may be one file
    std::string identity;
  };
  void add(File file);

  std::vector<File> files_;
};

/// Whether two paths lead to one file.
bool are_one_file(const std::string& path, const std::string& other);

}  // namespace tps::cli
