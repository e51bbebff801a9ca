#include "reference/process/interrupt.hpp"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace tps::interrupt {
namespace {

std::atomic<bool> signalled{false};
std::atomic<int> in_good_order{0};
std::atomic<void (*)()> last_act{nullptr};
std::atomic<const char*> name{"tps"};
timer_t grace{};
std::atomic<bool> has_grace{false};

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

/// A reader of our messages who takes none must not keep us.
void say(const char* text) {
  pollfd errors{STDERR_FILENO, POLLOUT, 0};
  if (::poll(&errors, 1, 0) != 1) return;
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, std::strlen(text));
}

[[noreturn]] void leave(const char* why) {
  if (void (*const act)() = last_act.load()) act();
  say(name.load());
  say(why);
  ::_exit(kExitCode);
}

extern "C" void note_signal(int) {
  const int error = errno;
  if (signalled.exchange(true)) leave(": interrupted twice, ended at once\n");
  if (in_good_order.load() == 0) leave(": interrupted\n");
  const itimerspec end{{0, 0}, {0, std::chrono::nanoseconds(kGrace).count()}};
  if (has_grace.load()) ::timer_settime(grace, 0, &end, nullptr);
  errno = error;
}

extern "C" void note_end_of_grace(int) {
  leave(": interrupted; it could not be ended in good order in time, what is written so far stays\n");
}

void take(int number, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;  // without SA_RESTART: whoever waits is woken
  ::sigaction(number, &action, nullptr);
}

sigset_t ours() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : kSignals) sigaddset(&set, number);
  return set;
}

bool is_ignored(int number) {
  struct sigaction action = {};
  return ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void install(const char* program) {
  name = program;
  sigevent expiry{};
  expiry.sigev_notify = SIGEV_SIGNAL;
  expiry.sigev_signo = SIGALRM;
  has_grace = ::timer_create(CLOCK_MONOTONIC, &expiry, &grace) == 0;
  take(SIGALRM, note_end_of_grace);
  take(SIGINT, note_signal);
  take(SIGTERM, note_signal);
  if (!is_ignored(SIGHUP)) take(SIGHUP, note_signal);  // nohup
  sigset_t open = ours();
  sigaddset(&open, SIGALRM);
  ::sigprocmask(SIG_UNBLOCK, &open, nullptr);
}

bool requested() {
  return signalled.load();
}

const std::atomic<bool>& flag() {
  return signalled;
}

void check() {
  if (requested()) throw Interrupted();
}

GoodOrder::GoodOrder() {
  // A signal that comes before this line has ended the process.
  ++in_good_order;
}

GoodOrder::~GoodOrder() {
  --in_good_order;
}

int wait(pollfd* awaited, nfds_t count, std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + timeout;
  const sigset_t quiet = ours();
  sigset_t before;
  ::sigprocmask(SIG_BLOCK, &quiet, &before);
  int ready = -1;
  while (!requested()) {
    const auto left = std::max(Clock::duration::zero(), deadline - Clock::now());
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec limit{seconds.count(), std::chrono::nanoseconds(left - seconds).count()};
    ready = ::ppoll(awaited, count, &limit, &before);
    if (ready >= 0 || errno != EINTR) break;
  }
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  check();
  return ready;
}

void before_leaving(void (*act)()) {
  last_act = act;
}

void forget() {
  last_act = nullptr;
  in_good_order = 0;
  signalled = false;
  // All of them: a guard ignores more than a program handles, and what is ignored stays so in what it
  // executes.
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

}  // namespace tps::interrupt
