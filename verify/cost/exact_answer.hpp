// What every variant is judged by: the verdict by integers and the time to a thousand bits. Shares the lift
// to integers with verify/exact, and neither its filters nor its rounding.
#pragma once

#include <memory>
#include <optional>

#include "verify/cost/variant.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::cost {

/// The quadratic a t² + 2 h t + c and its D against the sums of magnitudes that bound their roundings:
/// H = Σ|r_k v_k|, M = |r|² + L². Exact, then rounded to double.
struct Magnitudes {
  double h;    ///< |h| / H
  double c;    ///< |c| / M
  double D;    ///< |D| / (a M)
  double hh;   ///< h² / (a M)
  double rr;   ///< |r|² / M
  double LL;   ///< L² / M
  double ww;   ///< |r × v|² / (a M)
  double sum;  ///< (|h| + √D)² / (a M), D ≥ 0; else as hh
};

/// The exact answer to one query, and what makes it hard.
class ExactAnswer {
 public:
  /// REQUIRES valid(query).
  explicit ExactAnswer(const TimingQuery& query);
  ~ExactAnswer();
  ExactAnswer(ExactAnswer&&) noexcept;
  ExactAnswer& operator=(ExactAnswer&&) noexcept;

  exact::Verdict verdict() const { return verdict_; }
  bool occurs() const { return exact::occurs(verdict_); }
  bool at_once() const { return exact::at_once(verdict_); }
  /// Whether the time is a normal double: else infinite or rounded to nothing is right in double.
  bool in_range() const { return in_range_; }

  /// log2 |t̂ − t| / t, to which 2^-1000 is as good as nothing. REQUIRES occurs(), not at_once().
  double log2_error(const ExactNumber& t) const;

  /// |a t̂² + 2 h t̂ + c| / (a t̂² + 2 H t̂ + M): how far from the limit the pair is at t̂, as a relative error of
  /// the terms of eq. (1), squared. REQUIRES occurs(), not at_once().
  double residual(const ExactNumber& t) const;

  /// Absent for a pair without relative motion.
  const std::optional<Magnitudes>& magnitudes() const { return magnitudes_; }

  /// How much a relative error of one unit in each coefficient moves the time, in units
  /// (verify/vectors/time_bracket.hpp); absent where there is no time to move.
  std::optional<double> condition() const { return condition_; }

  /// log2 |D| / (a L²) = log2 |1 − (ρ/L)²|, ρ the distance of closest approach: how far from tangency. Absent
  /// where the verdict does not rest on D, and for D = 0.
  std::optional<double> log2_from_tangency() const { return log2_from_tangency_; }

 private:
  struct Time;
  exact::Verdict verdict_;
  bool in_range_ = false;
  std::unique_ptr<Time> time_;
  std::optional<Magnitudes> magnitudes_;
  std::optional<double> condition_, log2_from_tangency_;
};

}  // namespace tps::cost
