#include "reference/text/line_reader.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "reference/text/input_error.hpp"

namespace tps {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16;
constexpr std::size_t kShownOfLongLine = 60;

[[noreturn]] void fail(const std::string& source, int error) {
  throw InputError({{source, 0, "", fmt::format("cannot be read: {}", std::strerror(error))}});
}

/// Waits until there is something to read. A signal is let through only while waiting, so that none can slip
/// in between the question and the wait. @return whether to read; false where a stop was asked for.
bool wait_for_input(int descriptor, const std::function<bool()>& stop) {
  sigset_t quiet;
  sigset_t before;
  sigemptyset(&quiet);
  sigaddset(&quiet, SIGINT);
  sigaddset(&quiet, SIGTERM);
  sigaddset(&quiet, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &quiet, &before);
  bool stopped = stop();
  while (!stopped) {
    pollfd awaited{descriptor, POLLIN, 0};
    const bool ready = ::ppoll(&awaited, 1, nullptr, &before) >= 0;
    if (ready || errno != EINTR) break;
    stopped = stop();
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return !stopped;
}

}  // namespace

LineReader::Result LineReader::next() {
  std::size_t searched = 0;  // of what is there, without a line's end
  bool too_long = false;
  while (true) {
    const std::size_t end = buffer_.find('\n', begin_ + searched);
    const bool complete = end != std::string::npos;
    searched = (complete ? end : buffer_.size()) - begin_;
    if (!too_long && searched > longest_) {
      too_long = true;
      beginning_ = buffer_.substr(begin_, kShownOfLongLine);
    }
    if (complete) return taken(searched, 1, too_long);
    if (too_long) {
      begin_ = buffer_.size();
      searched = 0;
    }
    const Filled filled = fill();
    if (filled == Filled::interrupted) return {Status::interrupted, {}};
    if (filled == Filled::more) continue;
    if (!too_long && searched == 0) return {Status::end, {}};
    return taken(searched, 0, too_long);
  }
}

LineReader::Result LineReader::taken(std::size_t length, std::size_t end_length, bool too_long) {
  std::string_view text(buffer_.data() + begin_, length);
  begin_ += length + end_length;
  if (too_long) return {Status::too_long, beginning_};
  if (text.ends_with('\r')) text.remove_suffix(1);
  return {Status::line, text};
}

LineReader::Filled LineReader::fill() {
  before_waiting_();
  buffer_.erase(0, begin_);
  erased_ += begin_;
  begin_ = 0;
  while (true) {
    if (!wait_for_input(descriptor_, stop_)) return Filled::interrupted;
    const std::size_t there = buffer_.size();
    buffer_.resize(there + kBlock);
    const ssize_t got = ::read(descriptor_, buffer_.data() + there, kBlock);
    buffer_.resize(there + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got > 0) return Filled::more;
    if (got == 0) return Filled::end;
    if (errno != EINTR && errno != EAGAIN) fail(source_, errno);
  }
}

}  // namespace tps
