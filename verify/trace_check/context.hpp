// What every rule is given: the model before the event, where verdicts go, how the trace was timed.
#pragma once

#include <fmt/format.h>

#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/model.hpp"
#include "verify/trace_check/tally.hpp"
#include "verify/trace_check/turns.hpp"

namespace tps::check {

template <typename Number>
struct Context {
  using W = Work<Number>;

  Model<Number>& model;
  Tally& tally;
  Timing timing;
  bool minimal;
  certified::ExactTiming& exact;
  const Turns<Number>& turns;
  std::function<std::string(const Instant<Number>&)> shown_time;  ///< on the scene's clock
  int semantics = 0;       ///< of the trace (docs/decisions.md); 0: it does not say
  bool own_draws = false;  ///< its draws are those of our generator

  W u() const { return model.precision.u; }
  W scale() const { return W(tally.tolerance()); }
  bool certified() const { return timing == Timing::certified; }

  /// What times hi + lo may be off by: two roundings of the sum; of a minimal trace, the rounding of its
  /// times.
  W time_error(const Instant<Number>& t) const {
    using std::abs;
    const W size = abs(W(t.hi));
    return minimal ? W(2) * u() * (size + model.start_of_clock())
                   : W(4) * u() * u() * size + model.precision.smallest;
  }

  /// "3-7", by ids.
  std::string pair(int i, int j) const { return fmt::format("{}-{}", model.id(i), model.id(j)); }
};

/// A number in so many digits.
template <typename W>
std::string shown(const W& x, int digits) {
  if constexpr (std::is_floating_point_v<W>) {
    return fmt::format("{:.{}g}", x, digits);
  } else {
    return x.str(digits);
  }
}
/// Two numbers of a message, in as many digits as it takes to tell them apart.
template <typename W>
std::pair<std::string, std::string> told_apart(const W& a, const W& b) {
  for (const int digits : {9, 17, 21, 40, 110, 250}) {
    std::string of_a = shown(a, digits);
    std::string of_b = shown(b, digits);
    if (of_a != of_b || digits == 250) return {std::move(of_a), std::move(of_b)};
  }
  return {};
}
/// The same of vectors of two or three components.
template <typename W>
std::pair<std::string, std::string> told_apart(const Vec<W>& a, const Vec<W>& b, int dimension) {
  const auto spelt = [&](const Vec<W>& x, int digits) {
    std::string text;
    for (int k = 0; k < dimension; ++k)
      text += (k == 0 ? "(" : ", ") + shown(x[static_cast<std::size_t>(k)], digits);
    return text + ")";
  };
  for (const int digits : {9, 17, 21, 40, 110, 250}) {
    std::string of_a = spelt(a, digits);
    std::string of_b = spelt(b, digits);
    if (of_a != of_b || digits == 250) return {std::move(of_a), std::move(of_b)};
  }
  return {};
}

/// A number in a message.
template <typename W>
std::string shown(const W& x) {
  return fmt::format("{:.9g}", static_cast<double>(x));
}
template <typename W>
double as_double(const W& x) {
  return static_cast<double>(x);
}
/// Three or two components, as the scene has.
template <typename W>
std::string shown(const Vec<W>& x, int dimension) {
  std::string text = fmt::format("({:.9g}, {:.9g}", static_cast<double>(x[0]), static_cast<double>(x[1]));
  return text + (dimension == 3 ? fmt::format(", {:.9g})", static_cast<double>(x[2])) : ")");
}

}  // namespace tps::check
