// How far something is: a bar with rate and time left on a terminal, plain lines elsewhere, nothing when
// quiet.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace tps::cli {

struct Progress {
  double done, whole;  ///< of the quantity that the report names; a whole of ∞ where nobody knows it
  std::uint64_t events;
};

class ProgressReport {
 public:
  /// `quantity`: what `done` and `whole` measure, "t" or "MB".
  ProgressReport(bool quiet, std::string quantity);
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  void update(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  bool quiet_;
  std::string quantity_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_line_ = start_;
  std::uint64_t events_before_ = 0;
  double done_before_ = -1;
};

}  // namespace tps::cli
