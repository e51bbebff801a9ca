#include "properties/implementations/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

#include "properties/implementations/guard.hpp"
#include "properties/implementations/last_words.hpp"
#include "reference/process/interrupt.hpp"

namespace tps::properties {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr std::size_t kKeptOfErrors = 2000;
constexpr std::size_t kShown = 80;
/// For a guard to end what it watches.
constexpr std::chrono::milliseconds kTimeToEnd{3000};
/// Between the last word of a program and its end.
constexpr std::chrono::milliseconds kTimeToLeave{1000};

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

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

/// The guards there are, for a signal that ends the process: it waits a moment for them.
struct Registered {
  std::atomic<int> orders{-1}, reports{-1};
};
std::array<Registered, 8> registry;

void end_guards() {
  for (Registered& guard : registry) {
    if (const int orders = guard.orders.exchange(-1); orders >= 0) ::close(orders);
  }
  for (Registered& guard : registry) {
    const int reports = guard.reports.exchange(-1);
    for (int rounds = 0; reports >= 0 && rounds < 4; ++rounds) {
      pollfd awaited{reports, POLLIN, 0};
      std::array<char, 64> report{};
      if (::poll(&awaited, 1, 100) == 1 && ::read(reports, report.data(), report.size()) <= 0) break;
    }
  }
}

void enter(int orders, int reports) {
  interrupt::before_leaving(end_guards);
  for (Registered& guard : registry) {
    if (guard.orders.load() >= 0) continue;
    guard.reports = reports;
    guard.orders = orders;
    return;
  }
}

void strike_out(int orders) {
  for (Registered& guard : registry) {
    if (guard.orders.load() != orders) continue;
    guard.reports = -1;
    guard.orders = -1;
  }
}

void set_nonblocking(int descriptor) {
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

}  // namespace

ChildProcess::ChildProcess(const std::function<int()>& body) {
  std::signal(SIGPIPE, SIG_IGN);
  const Pipe input, output, errors, orders, reports;
  guard_ = ::fork();
  if (guard_ == 0) {
    ::close(orders.write);
    guard(body, {input.read, output.write, errors.write, orders.read, reports.write});
  }
  for (const int theirs : {input.read, output.write, errors.write, orders.read, reports.write})
    ::close(theirs);
  to_child_ = input.write;
  from_child_ = output.read;
  errors_ = errors.read;
  orders_ = orders.write;
  reports_ = reports.read;
  if (guard_ < 0) fail("cannot start a process");
  for (const int ours : {to_child_, from_child_, errors_, reports_}) set_nonblocking(ours);
  enter(orders_, reports_);
}

ChildProcess::~ChildProcess() {
  strike_out(orders_);
  for (int* ours : {&to_child_, &from_child_, &errors_, &orders_}) close_end(*ours);
  const Clock::time_point deadline = Clock::now() + kTimeToEnd;
  while (reports_ >= 0 && Clock::now() < deadline) {
    pollfd awaited{reports_, POLLIN, 0};
    if (::poll(&awaited, 1, 100) == 1) take_report();
  }
  if (reports_ >= 0) ::kill(guard_, SIGKILL);  // stopped by somebody
  close_end(reports_);
  ::waitpid(guard_, nullptr, 0);
  if (!has_ended_ && program_ > 0) ::kill(-program_, SIGKILL);
}

void ChildProcess::write_line(std::string_view text) {
  unsent_ += text;
  unsent_ += '\n';
  send();
}

void ChildProcess::send() {
  while (to_child_ >= 0 && !unsent_.empty()) {
    const ssize_t written = ::write(to_child_, unsent_.data(), unsent_.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EAGAIN) return;
    if (written < 0) return close_end(to_child_);  // how it ended shows when its reply is read
    unsent_.erase(0, static_cast<std::size_t>(written));
  }
}

void ChildProcess::take_output() {
  std::array<char, 65536> block{};
  const ssize_t got = ::read(from_child_, block.data(), block.size());
  if (got > 0) buffer_.append(block.data(), static_cast<std::size_t>(got));
  if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) close_end(from_child_);
}

void ChildProcess::take_errors() {
  std::array<char, 65536> block{};
  const ssize_t got = ::read(errors_, block.data(), block.size());
  if (got > 0) {
    written_errors_.append(block.data(), static_cast<std::size_t>(got));
    if (written_errors_.size() > kKeptOfErrors) {  // the last words say most
      written_errors_.erase(0, written_errors_.size() - kKeptOfErrors);
      errors_are_cut_ = true;
    }
  }
  if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) close_end(errors_);
}

void ChildProcess::take_report() {
  GuardReport report{};
  const ssize_t got = ::read(reports_, &report, sizeof report);
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (got != sizeof report) {
    strike_out(orders_);
    return close_end(reports_);
  }
  if (report.what == GuardReport::What::started) {
    program_ = report.value;
  } else {
    has_ended_ = true;
    status_ = report.value;
  }
}

void ChildProcess::exchange(std::chrono::milliseconds timeout) {
  const bool sends = to_child_ >= 0 && !unsent_.empty();
  // poll() passes over negative descriptors.
  std::array<pollfd, 4> awaited{{{from_child_, POLLIN, 0},
                                 {errors_, POLLIN, 0},
                                 {reports_, POLLIN, 0},
                                 {sends ? to_child_ : -1, POLLOUT, 0}}};
  if (interrupt::wait(awaited.data(), awaited.size(), timeout) <= 0) return;
  if (awaited[0].revents != 0) take_output();
  if (awaited[1].revents != 0) take_errors();
  if (awaited[2].revents != 0) take_report();
  if (awaited[3].revents != 0) send();
}

std::string ChildProcess::errors_to_add() const {
  const std::string said = last_lines(written_errors_, !errors_are_cut_);
  return said.empty() ? "" : "; its last words on standard error: " + said;
}

ChildProcess::Line ChildProcess::ended() {
  while (errors_ >= 0) {  // all writers are gone
    const std::size_t before = written_errors_.size();
    take_errors();
    if (written_errors_.size() == before) break;
  }
  const std::string rest =
      (buffer_.empty() ? "" : fmt::format(" in the middle of a line: {}", shown(buffer_, kShown))) +
      errors_to_add();
  if (!has_ended_) {
    if (reports_ >= 0) return {Line::Status::closed, "closed its output" + rest};
    return {Line::Status::ended, "ended, and its guard with it" + rest, 128 + SIGKILL, buffer_};
  }
  if (WIFEXITED(status_)) {
    const int code = WEXITSTATUS(status_);
    return {Line::Status::ended, fmt::format("ended with exit code {}{}", code, rest), code, buffer_};
  }
  const int signal = WTERMSIG(status_);
  return {Line::Status::ended, fmt::format("crashed: signal {} ({}){}", signal, ::strsignal(signal), rest),
          128 + signal, buffer_};
}

ChildProcess::Line ChildProcess::read_line(std::chrono::milliseconds timeout) {
  Clock::time_point deadline = Clock::now() + timeout;
  bool leaves = false;
  while (true) {
    const std::size_t end = buffer_.find('\n');
    if (end != std::string::npos) {
      Line line{Line::Status::line, buffer_.substr(0, end)};
      buffer_.erase(0, end + 1);
      return line;
    }
    if (buffer_.size() > kLongestLine) return {Line::Status::too_long, shown(buffer_, kShown)};
    if ((has_ended_ && from_child_ < 0) || reports_ < 0) return ended();
    if (from_child_ < 0 && !leaves) {
      leaves = true;
      deadline = Clock::now() + kTimeToLeave;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return leaves || has_ended_ ? ended() : Line{Line::Status::late, errors_to_add()};
    exchange(left);
  }
}

ChildProcess::Line ChildProcess::read_to_end(std::chrono::milliseconds timeout) {
  const Clock::time_point deadline = Clock::now() + timeout;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return {Line::Status::late, errors_to_add()};
    Line line = read_line(left);
    if (line.status == Line::Status::too_long) buffer_.clear();
    if (line.status == Line::Status::ended || line.status == Line::Status::late) return line;
    if (line.status == Line::Status::closed) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

std::function<int()> executing(std::vector<std::string> words) {
  return [words = std::move(words)] {
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    const std::string why = fmt::format("{}: {}\n", words[0], std::strerror(errno));
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, why.data(), why.size());
    return kNotExecuted;
  };
}

}  // namespace tps::properties
