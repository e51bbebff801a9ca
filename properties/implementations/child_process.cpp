#include "properties/implementations/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

namespace tps::properties {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("cannot open a pipe");
    read = ends[0];
    write = ends[1];
  }
  int read, write;
};

/// Never returns.
[[noreturn]] void become(const std::function<int()>& body, int input, int output) {
  ::dup2(input, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGINT, SIG_IGN);  // Ctrl-C is for the parent, which ends us
  int code = 70;
  try {
    code = body();
  } catch (...) {
    // 70: an error of ours
  }
  ::_exit(code);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<int()>& body) {
  const Pipe down, up;
  process_ = ::fork();
  if (process_ < 0) fail("cannot start a process");
  if (process_ == 0) become(body, down.read, up.write);
  ::close(down.read);
  ::close(up.write);
  to_child_ = down.write;
  from_child_ = up.read;
}

ChildProcess::~ChildProcess() {
  ::close(to_child_);
  ::close(from_child_);
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

bool ChildProcess::write_line(std::string_view text) {
  std::string line(text);
  line += '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(to_child_, line.data() + done, line.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    done += static_cast<std::size_t>(written);
  }
  return true;
}

ChildProcess::Line ChildProcess::ended() {
  const std::string rest =
      buffer_.empty() ? "" : fmt::format(" in the middle of a line: {}", buffer_.substr(0, 80));
  int status = 0;
  ::kill(process_, SIGKILL);  // it has closed its output; nothing more can come
  ::waitpid(process_, &status, 0);
  process_ = -1;
  if (WIFEXITED(status))
    return {Line::Status::ended, fmt::format("ended with exit code {}{}", WEXITSTATUS(status), rest)};
  const int signal = WTERMSIG(status);
  if (signal == SIGKILL) return {Line::Status::ended, "closed its output" + rest};
  return {Line::Status::ended, fmt::format("crashed: signal {} ({}){}", signal, ::strsignal(signal), rest)};
}

ChildProcess::Line ChildProcess::read_line(std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + timeout;
  while (true) {
    const std::size_t end = buffer_.find('\n');
    if (end != std::string::npos) {
      Line line{Line::Status::line, buffer_.substr(0, end)};
      buffer_.erase(0, end + 1);
      return line;
    }
    if (buffer_.size() > kLongestLine) return {Line::Status::too_long, buffer_.substr(0, 80)};
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return {Line::Status::late, ""};
    pollfd awaited{from_child_, POLLIN, 0};
    if (::poll(&awaited, 1, static_cast<int>(left)) <= 0) continue;
    std::array<char, 65536> block{};
    const ssize_t got = ::read(from_child_, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return ended();
    buffer_.append(block.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace tps::properties
