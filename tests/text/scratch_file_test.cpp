// Files of our own that nobody else needs.
#include "reference/text/scratch_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "reference/text/output.hpp"

namespace tps {
namespace {

/// $TMPDIR is another folder for as long as this lives.
class OtherFolder {
 public:
  explicit OtherFolder(const std::string& folder) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    ::setenv("TMPDIR", folder.c_str(), 1);
  }
  ~OtherFolder() {
    if (before_) {
      ::setenv("TMPDIR", before_->c_str(), 1);
    } else {
      ::unsetenv("TMPDIR");
    }
  }
  OtherFolder(const OtherFolder&) = delete;
  OtherFolder& operator=(const OtherFolder&) = delete;

 private:
  std::optional<std::string> before_;
};

TEST(ScratchFile, HoldsItsContentAndGoes) {
  std::string path;
  {
    const std::string content("two lines\nand a zero: \0.", 24);
    const ScratchFile file(content), other;
    path = file.path();
    EXPECT_EQ(file.content(), content);
    EXPECT_NE(other.path(), path);
    EXPECT_EQ(other.content(), "");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ScratchFile, SaysWhereThereCanBeNone) {
  const OtherFolder nowhere("/no/such/folder");
  try {
    const ScratchFile file;
    FAIL() << file.path();
  } catch (const OutputError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "/no/such/folder: a temporary file cannot be made there: No such file or directory; set TMPDIR to a "
        "folder that can be written");
  }
}

}  // namespace
}  // namespace tps
