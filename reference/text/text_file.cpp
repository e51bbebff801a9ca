#include "reference/text/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "reference/text/input_error.hpp"

namespace tps {
namespace {

[[noreturn]] void fail(const std::string& path, std::string message) {
  throw InputError(std::vector<InputProblem>{{display_name(path), 0, "", std::move(message)}});
}

struct CloseFile {
  void operator()(std::FILE* file) const {
    if (file != stdin) std::fclose(file);
  }
};

std::string error_text(int error) {
  return std::error_code(error, std::generic_category()).message();
}

}  // namespace

std::string display_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

std::string read_text_file(const std::string& path, std::size_t max_bytes, const std::string& remedy) {
  std::error_code ignored;
  if (path != "-" && std::filesystem::is_directory(path, ignored)) {
    fail(path, "this is a directory; name a file in it");
  }
  const std::unique_ptr<std::FILE, CloseFile> file(path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, fmt::format("cannot be opened: {}", error_text(errno)));

  std::string text;
  std::array<char, 65536> block;
  while (text.size() <= max_bytes) {
    const std::size_t wanted = std::min(block.size(), max_bytes + 1 - text.size());
    const std::size_t got = std::fread(block.data(), 1, wanted, file.get());
    text.append(block.data(), got);
    if (got < wanted) break;
  }
  if (std::ferror(file.get()) != 0) fail(path, fmt::format("cannot be read: {}", error_text(errno)));
  if (text.size() > max_bytes) {
    fail(path, fmt::format("is larger than {} bytes, the most that is read; {}", max_bytes, remedy));
  }
  return text;
}

}  // namespace tps
