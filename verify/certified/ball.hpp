// Enclosures of real numbers by Arb, at a precision that whoever evaluates chooses. Heavy header: only
// sources of this folder include it.
#pragma once

#include <memory>

#include "verify/certified/numbers.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::certified {

/// The precision at which balls are computed while it lives, and whether what was computed left a question
/// open. One a thread at a time; an inner one replaces the outer.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(long bits);
  ~WorkingPrecision();
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

  static long bits();
  /// Notes that a sign or a rounding could not be told at this precision.
  static void doubt();
  bool doubted() const { return doubted_; }

 private:
  WorkingPrecision* outer_;
  long bits_;
  bool doubted_ = false;
};

/// Evaluates at more and more bits until no question is open, or at the most that is tried. That there is
/// no answer is itself open while a question is.
template <typename Evaluation>
auto settled(const Evaluation& evaluate) {
  constexpr long first_bits = 512, most_bits = 1L << 14;
  for (long bits = first_bits;; bits *= 2) {
    WorkingPrecision precision(bits);
    const auto is_final = [&] { return !precision.doubted() || bits >= most_bits; };
    try {
      auto result = evaluate();
      if (is_final()) return result;
    } catch (const operations::NoAnswer&) {
      if (is_final()) throw;
    }
  }
}

/// An interval that holds a real number. Law: whatever the operands may be, the result holds the true value;
/// Arb's rigorous balls are what proves it.
class Ball {
 public:
  explicit Ball(const Rational& x);

  struct Ends {
    Rational lo, hi;
  };
  /// Where nothing is known (a division by what may be zero), from below the doubles to above them: a doubt.
  Ends ends() const;
  /// Uncertain, which is a doubt, where zero lies inside.
  Sign sign() const;

  friend Ball operator+(const Ball& x, const Ball& y);
  friend Ball operator*(const Ball& x, const Ball& y);
  /// REQUIRES sign(y) certain.
  friend Ball operator/(const Ball& x, const Ball& y);
  /// REQUIRES x ≥ 0 (the interval may reach below).
  friend Ball sqrt(const Ball& x);
  /// cos²(π x).
  friend Ball cos_squared_pi(const Ball& x);
  /// REQUIRES x > 0.
  friend Ball pow(const Ball& x, const Ball& y);

 private:
  struct Arb;
  Ball();
  std::shared_ptr<Arb> arb_;
};

}  // namespace tps::certified
