// How far a run is: a bar with rate and time left on a terminal, plain lines elsewhere, nothing when quiet.
#pragma once

#include <chrono>
#include <string>

#include "reference/run/run.hpp"

namespace tps::cli {

class ProgressReport {
 public:
  /// `quantity`: what Progress::t and duration measure.
  explicit ProgressReport(bool quiet, std::string quantity = "t");
  ~ProgressReport();
  ProgressReport(const ProgressReport&) = delete;
  ProgressReport& operator=(const ProgressReport&) = delete;

  void update(const RunOptions::Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  bool quiet_;
  std::string quantity_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_line_ = start_;
  std::uint64_t events_before_ = 0;
  double t_before_ = -1;
};

}  // namespace tps::cli
