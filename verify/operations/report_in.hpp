// A report whose values are numbers of one scalar. Heavy header: evaluate_in.hpp includes it.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "reference/equations/vector.hpp"
#include "reference/text/hexfloat.hpp"
#include "verify/operations/no_answer.hpp"
#include "verify/operations/report.hpp"

namespace tps::operations {

template <typename Scalar>
class ReportIn {
 public:
  ReportIn(std::string_view scalar, Detail detail) : scalar_(scalar), detail_(detail) {}

  const Report& report() const { return report_; }

 protected:
  static bool finite(const Scalar& x) {
    using std::abs;
    return abs(x) <= (std::numeric_limits<Scalar>::max)();  // false for NaN, too
  }
  [[noreturn]] void refuse(const std::string& message) const {
    throw NoAnswer(message + "; use a wider --scalar or other numbers");
  }
  std::string_view scalar() const { return scalar_; }

  /// Whether steps are shown: what only they need is not computed otherwise.
  bool shows_steps() const { return detail_ == Detail::everything; }
  template <typename Value>
  void step(const char* key, const char* symbol, const char* formula, const Value& x) {
    if (shows_steps()) report_.steps.push_back(quantity(key, symbol, formula, x));
  }
  template <typename Value>
  void result(const char* key, const char* symbol, const Value& x) {
    report_.results.push_back(quantity(key, symbol, "", x));
  }
  void word(const char* key, std::string_view value) {
    report_.results.push_back({key, key, "", {}, false, std::string(value)});
  }
  void time(const std::optional<Scalar>& t, const char* symbol = "Δt") {  // may lie beyond the range: ∞
    Quantity q{"t", symbol, "", {}, false, ""};
    if (t) q.numbers.push_back(spelled(*t));
    report_.results.push_back(q);
  }

 private:
  Number spelled(const Scalar& x) const {
    if (detail_ == Detail::bare_results) return {"", to_hex(x)};
    if constexpr (std::is_floating_point_v<Scalar>) {
      return {fmt::format("{}", x), to_hex(x)};
    } else {
      return {x.str(std::numeric_limits<Scalar>::max_digits10), to_hex(x)};
    }
  }
  Quantity quantity(const char* key, const char* symbol, const char* formula, const Scalar& x) const {
    if (!finite(x))
      refuse(fmt::format("{} is not a finite {}: the numbers are beyond its range", symbol, scalar_));
    return {key, symbol, formula, {spelled(x)}, false, ""};
  }
  /// A spin of the plane, a vector of one component, is a number.
  template <int N>
  Quantity quantity(const char* key, const char* symbol, const char* formula,
                    const Vector<Scalar, N>& x) const {
    Quantity q{key, symbol, formula, {}, N > 1, ""};
    for (int k = 0; k < N; ++k) q.numbers.push_back(quantity(key, symbol, formula, Scalar(x[k])).numbers[0]);
    return q;
  }

  std::string_view scalar_;
  Detail detail_;
  Report report_;
};

}  // namespace tps::operations
