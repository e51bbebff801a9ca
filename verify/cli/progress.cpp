#include "verify/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "verify/cli/line_every.hpp"
#include "verify/cli/say.hpp"

namespace tps::cli {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::seconds kBetweenLines(5);

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

ProgressReport::ProgressReport(bool quiet, std::string quantity)
    : quiet_(!may_say_progress(quiet)),
      quantity_(std::move(quantity)),
      terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressReport::~ProgressReport() {
  if (drawn_) say("\r\033[K");
}

void ProgressReport::update(const Progress& progress) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  if (done_before_ < 0) {  // a resumed run did not start at zero
    done_before_ = progress.done;
    events_before_ = progress.events;
    return;
  }
  if (!terminal_ && now - last_line_ < kBetweenLines) return;
  last_line_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(progress.events - events_before_) / seconds;
  std::string text =
      fmt::format("{} events, {:.3g} events/s, {} = {:.6g}", progress.events, rate, quantity_, progress.done);
  if (std::isfinite(progress.whole)) {
    const double part = std::clamp(progress.done / progress.whole, 0.0, 1.0);
    const double done_here = progress.done - done_before_;
    const std::string left =
        done_here > 0 ? duration_text(seconds * (progress.whole - progress.done) / done_here) + " left" : "";
    const auto filled = static_cast<int>(part * kBarWidth);
    const std::string bar =
        terminal_ ? fmt::format("[{:#<{}}{:.<{}}] ", "", filled, "", kBarWidth - filled) : "";
    text = fmt::format("{}{:3.0f} %  {} of {:.6g}  {}", bar, 100 * part, text, progress.whole, left);
  }
  if (terminal_) {
    say("\r{}\033[K", text);
    drawn_ = true;
  } else {
    say("{}\n", text);
  }
  std::fflush(stderr);
}

}  // namespace tps::cli
