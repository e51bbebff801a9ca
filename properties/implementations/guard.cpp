#include "properties/implementations/guard.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "reference/process/interrupt.hpp"

namespace tps::properties {
namespace {

/// Where the system runs out of memory, the program goes and we stay.
void offer_as_victim() {
  const int score = ::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (score < 0) return;
  [[maybe_unused]] const ssize_t ignored = ::write(score, "1000", 4);
  ::close(score);
}

[[noreturn]] void become_program(const std::function<int()>& body, const GuardedPipes& pipes, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(70);
  ::dup2(pipes.input, STDIN_FILENO);
  ::dup2(pipes.output, STDOUT_FILENO);
  ::dup2(pipes.errors, STDERR_FILENO);
  ::close_range(STDERR_FILENO + 1, ~0U, 0);
  offer_as_victim();
  interrupt::forget();
  int code = 70;
  try {
    code = body();
  } catch (...) {
    // 70: an error of ours
  }
  ::_exit(code);
}

/// Nothing of the caller's stays open but the two pipes; a reader of the caller's output does not wait for
/// us.
void keep_only(int& orders, int& reports) {
  const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (int standard = 0; standard <= STDERR_FILENO; ++standard) ::dup2(null, standard);
  constexpr int kAbove = 64;
  orders = ::fcntl(orders, F_DUPFD_CLOEXEC, kAbove);
  reports = ::fcntl(reports, F_DUPFD_CLOEXEC, orders + 1);
  ::close_range(STDERR_FILENO + 1, static_cast<unsigned>(orders - 1), 0);
  ::close_range(static_cast<unsigned>(reports + 1), ~0U, 0);
}

void report(int reports, GuardReport::What what, int value) {
  const GuardReport text{what, value};
  [[maybe_unused]] const ssize_t ignored = ::write(reports, &text, sizeof text);
}

/// The parent of a process, 0 where it is gone.
pid_t parent_of(const char* process) {
  std::array<char, 300> path{};
  std::snprintf(path.data(), path.size(), "/proc/%s/stat", process);
  std::FILE* file = std::fopen(path.data(), "re");
  if (file == nullptr) return 0;
  int parent = 0;
  std::array<char, 512> line{};
  if (std::fgets(line.data(), static_cast<int>(line.size()), file) != nullptr) {
    // "pid (name) state parent …", and the name may be anything.
    const std::string_view text(line.data());
    const std::size_t end = text.rfind(')');
    if (end != std::string_view::npos) std::sscanf(text.data() + end + 1, " %*c %d", &parent);
  }
  std::fclose(file);
  return parent;
}

void kill_children() {
  DIR* processes = ::opendir("/proc");
  if (processes == nullptr) return;
  const pid_t self = ::getpid();
  while (const dirent* entry = ::readdir(processes)) {
    const pid_t process = std::atoi(entry->d_name);
    if (process > 1 && parent_of(entry->d_name) == self) ::kill(process, SIGKILL);
  }
  ::closedir(processes);
}

/// Those whose parent has ended are our children: until there is none. @return whether there is none.
bool end_descendants(std::chrono::seconds limit) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + limit;
  while (Clock::now() < deadline) {
    pid_t ended = 0;
    while ((ended = ::waitpid(-1, nullptr, WNOHANG)) > 0) {
    }
    if (ended < 0) return true;
    kill_children();
    ::poll(nullptr, 0, 1);
  }
  return false;
}

/// @return whether the program has ended; others that have are forgotten.
bool has_ended(pid_t program, int& status) {
  siginfo_t who{};
  while (::waitid(P_ALL, 0, &who, WEXITED | WNOHANG | WNOWAIT) == 0 && who.si_pid != 0) {
    if (who.si_pid == program) {
      ::kill(-program, SIGKILL);  // before its number is free
      ::waitpid(program, &status, 0);
      return true;
    }
    ::waitpid(who.si_pid, nullptr, 0);
    who = {};
  }
  return false;
}

}  // namespace

void guard(const std::function<int()>& body, const GuardedPipes& pipes) {
  ::setsid();  // Ctrl-C is for the caller
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGUSR1, SIGUSR2, SIGALRM})
    std::signal(number, SIG_IGN);
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t children;
  sigemptyset(&children);
  sigaddset(&children, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &children, nullptr);
  const pid_t self = ::getpid();
  const pid_t program = ::fork();
  if (program == 0) become_program(body, pipes, self);
  int orders = pipes.orders, reports = pipes.reports;
  keep_only(orders, reports);
  if (program < 0) ::_exit(70);
  ::setpgid(program, program);
  report(reports, GuardReport::What::started, program);

  const int ends = ::signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK);
  int status = 0;
  while (!has_ended(program, status)) {
    std::array<pollfd, 2> awaited{{{orders, POLLIN, 0}, {ends, POLLIN, 0}}};
    ::poll(awaited.data(), awaited.size(), -1);
    if (awaited[0].revents != 0) {
      ::kill(-program, SIGKILL);
      ::kill(program, SIGKILL);
      break;
    }
    signalfd_siginfo ignored{};
    while (::read(ends, &ignored, sizeof ignored) > 0) {
    }
  }
  // Who asked need not wait for a machine so busy that looking for them takes longer; they end all the same.
  const bool all = end_descendants(std::chrono::seconds(2));
  report(reports, GuardReport::What::ended, status);
  if (!all) end_descendants(std::chrono::minutes(5));
  ::_exit(0);
}

}  // namespace tps::properties
