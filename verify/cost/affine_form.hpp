// Affine arithmetic: real numbers enclosed together with how they hang together (Stolfi and de Figueiredo,
// 1997; docs/accuracy-cost.md, "What is proven"). Heavy header: Arb.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/certified/arb_functions.hpp"

namespace tps::cost {

enum class CertainSign { negative, zero, positive, unknown };

/// The set { c + Σ f_k ε_k : c in the centre, −1 ≤ ε_k ≤ 1 }. The centre is a ball of Arb, the factors are
/// doubles. Forms share the symbols ε_k, so that a difference of two knows what cancels.
///
/// Law: whatever values of the symbols, the result of an operation holds the true result of the operands that
/// these values give. What rounding of the factors and terms of second order may add is in the centre's
/// radius.
class AffineForm {
 public:
  /// The double, exactly; results are computed with centres of so many bits.
  AffineForm(double x, long bits);
  ~AffineForm() { loaded::arb_clear(centre_); }
  AffineForm(const AffineForm& other);
  AffineForm(AffineForm&& other) noexcept;
  AffineForm& operator=(AffineForm other) noexcept;

  /// Adds `by` · ε, of a symbol later than all that this form has.
  void widen(double by, std::uint32_t symbol);
  /// Makes the centre a point again: its radius, and factors below 2^-30 of all together, become the factor
  /// of a symbol later than all before. A superset of the form.
  void absorb(std::uint32_t symbol);
  /// The same set without symbols: fast to compute with, and blind to what cancels.
  AffineForm alone() const;

  /// The part of the set where a symbol has a value. REQUIRES −1 ≤ value ≤ 1.
  AffineForm given(std::uint32_t symbol, double value) const;

  CertainSign sign() const;
  /// Doubles at or beyond the ends.
  double lower() const;
  double upper() const;
  bool is_finite() const;
  std::size_t symbols() const { return factors_.size(); }

  friend AffineForm operator+(const AffineForm& x, const AffineForm& y);
  friend AffineForm operator-(const AffineForm& x, const AffineForm& y);
  friend AffineForm operator*(const AffineForm& x, const AffineForm& y);
  friend AffineForm operator-(const AffineForm& x);
  /// REQUIRES sign(x) negative or positive.
  friend AffineForm inverse(const AffineForm& x);
  /// REQUIRES sign(x) positive.
  friend AffineForm sqrt(const AffineForm& x);
  friend AffineForm tan_degrees(double theta, long bits);
  friend AffineForm cos_degrees(double theta, long bits);
  friend AffineForm speed_ratio(double c, double theta_deg, long bits);

 private:
  struct Factor {
    std::uint32_t symbol;
    double factor;
  };
  /// What one operand of an operation contributes: the double that its factors are multiplied by, and how far
  /// the true multiplier may be from it.
  struct Multiplier {
    double value = 0, error = 0;
  };

  explicit AffineForm(long bits);
  static Multiplier multiplier(const arb_t x);
  /// centre + p x + q y but for the centres of x and y, with an error of at most `second_order` more.
  static AffineForm combined(AffineForm centre, Multiplier p, const AffineForm& x, Multiplier q,
                             const AffineForm& y, double second_order);
  /// Σ|f_k|, rounded up.
  double reach() const;
  void add_error(double error);

  arb_t centre_;
  long bits_;
  std::vector<Factor> factors_;  ///< by symbol, ascending
};

/// tan θ and cos θ of an angle in degrees, and c^(θ/180°): the constants of eq. (5). REQUIRES 0 < θ < 90, c >
/// 0.
AffineForm tan_degrees(double theta, long bits);
AffineForm cos_degrees(double theta, long bits);
AffineForm speed_ratio(double c, double theta_deg, long bits);

}  // namespace tps::cost
