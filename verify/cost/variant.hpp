// A variant: one way to answer a timing query in one arithmetic, as the study asks it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reference/equations/timing_verdict.hpp"
#include "verify/exact/counters.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::cost {

using exact::TimingQuery;

/// A number of any scalar up to 8·53 bits without rounding: 2^exponent times the sum of the parts. The first
/// part lies in [1/2, 1], so that no part underflows.
struct ExactNumber {
  int exponent = 0;
  std::array<double, 8> parts{};
};

/// What a variant says. An event without a time (verdict only) and an infinite time have no number.
struct Answer {
  bool occurs = false;
  std::optional<ExactNumber> t;
  bool at_once = false;                  ///< t is 0
  std::optional<TimingVerdict> verdict;  ///< of variants that name it
};

struct Variant {
  std::string name;        ///< formula-arithmetic, as `--variant` takes it
  std::string formula;     ///< key of formulas()
  std::string arithmetic;  ///< float, double, …
  int bits = 0;            ///< of the significand it works in
  bool has_time = true;    ///< false: verdict only

  std::function<Answer(const TimingQuery&)> answer;
  /// Answers all, one independent of the other.
  std::function<void(std::span<const TimingQuery>)> throughput;
  /// Answers all, each query made from the answer before (by bits that are zero), or asked behind it.
  std::function<void(std::span<const TimingQuery>)> latency;
  /// Of a filtered variant: how many questions it hands on; empty for the others.
  std::function<exact::Counters(std::span<const TimingQuery>)> counted = {};

  std::string what = {};   ///< of a variant whose formula is not among formulas(): what it is
  bool elsewhere = false;  ///< answers in another process: timed by the clock on the wall
};

/// What a formula is, in a line.
struct Formula {
  std::string name, what;
};
const std::vector<Formula>& formulas();

/// Every variant, in the order of the tables: by formula, then by bits. The first is the one that ratios are
/// taken against.
const std::vector<Variant>& variants();

/// The arithmetic of somebody else's variant; figures show it beside ours, whatever they select.
inline constexpr const char* kForeignArithmetic = "yours";

/// What every time is compared with: eq. (2) as printed in double.
inline constexpr const char* kBaseline = "printed-double";

}  // namespace tps::cost
