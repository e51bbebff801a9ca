#include "verify/cli/named_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

namespace tps::cli {
namespace {

namespace fs = std::filesystem;

std::string of_node(const struct stat& about) {
  return fmt::format("{}:{}", about.st_dev, about.st_ino);
}

/// Where a file that is not there yet would be made: dangling links followed, folders by their own names.
std::string place_of(fs::path path) {
  constexpr int kMostLinks = 40;  // as the system's own limit
  std::error_code none;
  for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(path, none)); ++links) {
    const fs::path target = fs::read_symlink(path, none);
    if (none) break;
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const fs::path canonical = fs::canonical(folder, none);
  return ((none ? folder.lexically_normal() : canonical) / path.filename()).string();
}

/// Empty for what is no file: a device, a terminal.
std::string identity_of(const std::string& path) {
  struct stat about = {};
  if (::stat(path.c_str(), &about) != 0) return place_of(path);
  return S_ISREG(about.st_mode) || S_ISFIFO(about.st_mode) ? of_node(about) : "";
}

std::string identity_of_stream(int descriptor) {
  struct stat about = {};
  return ::fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode) ? of_node(about) : "";
}

}  // namespace

void NamedFiles::add(File file) {
  if (!file.identity.empty()) files_.push_back(std::move(file));
}

NamedFiles& NamedFiles::reads(const std::string& option, const std::string& path) {
  if (path == "-") {
    add({"standard input (" + option + " -)", "", false, true, identity_of_stream(STDIN_FILENO)});
  } else if (!path.empty()) {
    add({option, path, false, false, identity_of(path)});
  }
  return *this;
}

NamedFiles& NamedFiles::writes(const std::string& option, const std::string& path) {
  if (!path.empty() && path != "-") add({option, path, true, false, identity_of(path)});
  return *this;
}

void NamedFiles::require_distinct() const {
  NamedFiles all = *this;
  all.add({"standard output", "", true, true, identity_of_stream(STDOUT_FILENO)});
  all.add({"standard error", "", true, true, identity_of_stream(STDERR_FILENO)});
  for (const File& a : all.files_) {
    for (const File& b : all.files_) {
      if (&a == &b) break;
      if (!(a.written || b.written) || a.identity != b.identity) continue;
      if (a.stream && b.stream && a.written && b.written) continue;  // > log 2>&1
      const auto shown = [](const File& f) { return f.path.empty() ? f.option : f.option + " " + f.path; };
      throw CLI::ValidationError(
          fmt::format("{} and {} are one file; what is written needs a file of its own, so name another",
                      shown(b), shown(a)));
    }
  }
}

bool are_one_file(const std::string& path, const std::string& other) {
  if (path.empty() || other.empty() || path == "-" || other == "-") return false;
  const std::string identity = identity_of(path);
  return !identity.empty() && identity == identity_of(other);
}

}  // namespace tps::cli
