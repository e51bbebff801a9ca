#include "reference/trace/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace tps {
namespace {

constexpr std::size_t kBufferSize = 1U << 16U;

std::string message(const std::string& path, const char* action) {
  const std::string name = path == "-" ? "standard output" : "'" + path + "'";
  return name + ": cannot " + action + ": " + std::strerror(errno);
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
  descriptor_ =
      path == "-" ? STDOUT_FILENO : ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("create the file");
}

Output::Output(const std::string& path, std::uint64_t keep) : path_(path) {
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail("open the file");
  const off_t end = static_cast<off_t>(keep);
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, end, SEEK_SET) != end)
    fail("go on in the file");
}

Output::~Output() {
  try {
    close();
  } catch (const OutputError&) {
    // Only reached while another exception is on its way: close() was not called.
  }
}

void Output::write(std::string_view text) {
  buffer_.append(text);
  if (buffer_.size() >= kBufferSize) flush();
}

void Output::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      buffer_.clear();
      fail("write everything");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
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

void replace_file(const std::string& path, std::string_view content) {
  const std::string unfinished = path + ".unfinished";
  Output output(unfinished);
  output.write(content);
  output.close();
  if (std::rename(unfinished.c_str(), path.c_str()) != 0)
    throw OutputError(message(path, "replace the file"));
}

}  // namespace tps
