#include "reference/text/output.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "reference/text/background_writer.hpp"

namespace tps {
namespace {

constexpr std::size_t kBufferSize = 1U << 16U;
constexpr std::size_t kBackgroundBufferSize = 1U << 18U;  // the longer, the fewer times two threads meet

std::string message(const std::string& path, const char* action) {
  const std::string name = path == "-" ? "standard output" : "'" + path + "'";
  return name + ": cannot " + action + ": " + std::strerror(errno);
}

}  // namespace

Output::Output(const std::string& path) : Output(path, Reserve::only) {
  begin();
}

Output::Output(const std::string& path, Reserve) : path_(path) {
  open_locked(O_CREAT);
}

void Output::begin(std::uint64_t keep) {
  made_empty_ = false;
  if (!is_file_) return;
  const off_t end = static_cast<off_t>(keep);
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) != end)
    fail(keep == 0 ? "empty the file" : "go on in the file");
}

Output::Output(const std::string& path, Append) : path_(path) {
  open_locked(O_CREAT | O_APPEND);
}

void Output::open_locked(int mode) {
  if (path_ == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_EXCL | mode, 0666);
  made_empty_ = descriptor_ >= 0 && (mode & O_APPEND) == 0;
  while (descriptor_ < 0 && (errno == EEXIST || errno == EINTR))  // EINTR: a pipe that nobody reads yet
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | mode, 0666);
  if (descriptor_ < 0) fail("create the file");
  struct stat about = {};
  is_file_ = ::fstat(descriptor_, &about) == 0 && S_ISREG(about.st_mode);
  if (!is_file_ || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  descriptor_ = -1;
  throw OutputError("'" + path_ +
                    "': another process is writing this file; wait until it has ended, or name another");
}

Output::~Output() {
  if (made_empty_) ::unlink(path_.c_str());
  try {
    close();
  } catch (const std::exception&) {
    // Only reached while another exception is on its way: close() was not called.
  }
}

void Output::write(std::string_view text) {
  buffer_.append(text);
  if (buffer_.size() < (background_ == nullptr ? kBufferSize : kBackgroundBufferSize)) return;
  send();
}

void Output::write(std::function<void(std::string&)> make) {
  if (background_ == nullptr) {
    make(buffer_);
    if (buffer_.size() >= kBufferSize) flush();
    return;
  }
  send();
  in_background([&] { background_->hand_over(std::move(make)); });
}

void Output::send() {
  if (background_ == nullptr) return flush();
  in_background([this] { background_->hand_over(buffer_); });
}

template <typename Action>
void Output::in_background(const Action& action) try {
  action();
} catch (const OutputError&) {
  buffer_.clear();
  throw;
}

void Output::settle() noexcept {
  if (background_ != nullptr) background_->settle();
}

void Output::write_in_background() {
  if (BackgroundWriter::pays())
    background_ = std::make_unique<BackgroundWriter>([this](std::string_view text) { write_out(text); });
}

void Output::flush() {
  if (background_ != nullptr) in_background([this] { background_->wait(); });
  std::string text;
  text.swap(buffer_);
  write_out(text);
  text.clear();
  buffer_.swap(text);  // its memory is kept
}

void Output::write_out(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("write everything");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void Output::close() {
  if (descriptor_ < 0) return;
  const int descriptor = descriptor_;
  flush();
  descriptor_ = -1;
  if (descriptor != STDOUT_FILENO && ::close(descriptor) != 0) fail("close the file");
}

void Output::fail(const char* action) const {
  throw OutputError(message(path_, action));
}

namespace {

/// What is replaced is the file, there or yet to be made, and not a link to it.
void follow_links(std::string& path) {
  constexpr int kMostLinks = 40;  // as the system's own limit
  std::error_code none;
  for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(path, none)); ++links) {
    errno = ELOOP;
    if (links == kMostLinks) throw OutputError(message(path, "replace the file"));
    const std::filesystem::path target = std::filesystem::read_symlink(path, none);
    path = (std::filesystem::path(path).parent_path() / target).string();
  }
}

bool exists(const std::string& path) {
  struct stat about = {};
  return ::stat(path.c_str(), &about) == 0;
}

/// Whether a path leads to an open file.
bool is_there(int descriptor, const std::string& path) {
  struct stat there = {}, held = {};
  return ::stat(path.c_str(), &there) == 0 && ::fstat(descriptor, &held) == 0 &&
         there.st_dev == held.st_dev && there.st_ino == held.st_ino;
}

}  // namespace

ReplacedFile::ReplacedFile(const std::string& path) : path_(path) {
  follow_links(path_);
  struct stat about = {};
  if (::stat(path_.c_str(), &about) != 0) return;
  if (!S_ISREG(about.st_mode))
    throw OutputError("'" + path + "': is no file that can be replaced; name a file, or one yet to be made");
  ours_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  if (ours_ >= 0 && ::flock(ours_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(ours_);
    throw OutputError(
        "'" + path +
        "': another process keeps its state in this file; wait until it has ended, or name another");
  }
}

ReplacedFile::~ReplacedFile() {
  if (ours_ >= 0) ::close(ours_);
}

void ReplacedFile::replace(std::string_view content) {
  const std::string unfinished = path_ + ".unfinished";
  Output output(unfinished);
  output.write(content);
  output.close();
  const int next = ::open(unfinished.c_str(), O_RDONLY | O_CLOEXEC);
  const bool taken = next >= 0 && ::flock(next, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  // Whoever began at the same moment, when there was no file to lock, may have put theirs here.
  if (taken || (ours_ < 0 ? exists(path_) : exists(path_) && !is_there(ours_, path_))) {
    if (next >= 0) ::close(next);
    throw OutputError("'" + path_ + "': another process has replaced this file meanwhile; name another");
  }
  if (std::rename(unfinished.c_str(), path_.c_str()) != 0) {
    const std::string why = message(path_, "replace the file");
    if (next >= 0) ::close(next);
    throw OutputError(why);
  }
  if (ours_ >= 0) ::close(ours_);
  ours_ = next;
}

}  // namespace tps
