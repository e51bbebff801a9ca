#include "verify/cost/affine_form.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tps::cost {
namespace {

constexpr double kUnit = 0x1p-53;
/// Above what a sum of 2^22 doubles, or a product of few, errs by.
constexpr double kUp = 1 + 0x1p-30;
constexpr double kLeast = 0x1p-1074;
constexpr double kTiny = 0x1p-30;  ///< of a form's reach: a factor that is not worth a symbol

/// Exact, since a bound of Arb has 30 bits, but for what lies below the least double or above the greatest.
double upper_bound(const mag_t x) {
  const double value = loaded::mag_get_d(x);
  return value == 0 && loaded::mag_is_zero(x) == 0 ? kLeast : value;
}

/// sup |x| of a ball.
double largest(const arb_t x) {
  mag_t bound;
  loaded::mag_init(bound);
  loaded::arb_get_mag(bound, x);
  const double result = upper_bound(bound);
  loaded::mag_clear(bound);
  return result;
}

/// A ball as long as it is needed.
class Ball {
 public:
  Ball() { loaded::arb_init(x_); }
  explicit Ball(const arb_t x) : Ball() { loaded::arb_set(x_, x); }
  ~Ball() { loaded::arb_clear(x_); }
  Ball(const Ball&) = delete;
  Ball& operator=(const Ball&) = delete;
  arb_ptr get() { return x_; }

 private:
  arb_t x_;
};

void widen_ball(arb_t x, double by) {
  mag_t error;
  loaded::mag_init(error);
  loaded::mag_set_d(error, by);  // an upper bound
  loaded::arb_add_error_mag(x, error);
  loaded::mag_clear(error);
}

}  // namespace

AffineForm::AffineForm(long bits) : bits_(bits) {
  loaded::arb_init(centre_);
}

AffineForm::AffineForm(double x, long bits) : AffineForm(bits) {
  loaded::arb_set_d(centre_, x);
}

AffineForm::AffineForm(const AffineForm& other) : AffineForm(other.bits_) {
  loaded::arb_set(centre_, other.centre_);
  factors_ = other.factors_;
}

AffineForm::AffineForm(AffineForm&& other) noexcept : AffineForm(other.bits_) {
  loaded::arb_swap(centre_, other.centre_);
  factors_.swap(other.factors_);
}

AffineForm& AffineForm::operator=(AffineForm other) noexcept {
  loaded::arb_swap(centre_, other.centre_);
  factors_.swap(other.factors_);
  bits_ = other.bits_;
  return *this;
}

void AffineForm::widen(double by, std::uint32_t symbol) {
  if (by > 0) factors_.push_back({symbol, by});
}

void AffineForm::absorb(std::uint32_t symbol) {
  const double least = kTiny * reach();
  double rest = upper_bound(arb_radref(centre_));
  loaded::mag_zero(arb_radref(centre_));
  const auto is_tiny = [&](const Factor& f) { return std::fabs(f.factor) < least; };
  for (const Factor& f : factors_) {
    if (is_tiny(f)) rest += std::fabs(f.factor);
  }
  std::erase_if(factors_, is_tiny);
  widen(rest * kUp, symbol);
}

double AffineForm::reach() const {
  double sum = 0;
  for (const Factor& f : factors_) sum += std::fabs(f.factor);
  return sum * kUp;
}

void AffineForm::add_error(double error) {
  widen_ball(centre_, error);
}

AffineForm AffineForm::alone() const {
  AffineForm result(bits_);
  loaded::arb_set(result.centre_, centre_);
  result.add_error(reach());
  return result;
}

AffineForm AffineForm::given(std::uint32_t symbol, double value) const {
  AffineForm result(*this);
  const auto is_it = [&](const Factor& f) { return f.symbol == symbol; };
  const auto found = std::find_if(factors_.begin(), factors_.end(), is_it);
  if (found == factors_.end()) return result;
  std::erase_if(result.factors_, is_it);
  Ball factor, at;
  loaded::arb_set_d(factor.get(), found->factor);
  loaded::arb_set_d(at.get(), value);
  loaded::arb_addmul(result.centre_, factor.get(), at.get(), bits_);
  return result;
}

CertainSign AffineForm::sign() const {
  const AffineForm all = alone();
  if (loaded::arb_is_zero(all.centre_) != 0) return CertainSign::zero;
  if (loaded::arb_is_positive(all.centre_) != 0) return CertainSign::positive;
  return loaded::arb_is_negative(all.centre_) != 0 ? CertainSign::negative : CertainSign::unknown;
}

double AffineForm::lower() const {
  const AffineForm all = alone();
  arf_t end;
  loaded::arf_init(end);
  loaded::arb_get_lbound_arf(end, all.centre_, bits_);
  const double result = loaded::arf_get_d(end, ARF_RND_FLOOR);
  loaded::arf_clear(end);
  return result;
}

double AffineForm::upper() const {
  return -(-*this).lower();
}

bool AffineForm::is_finite() const {
  return loaded::arb_is_finite(centre_) != 0 && std::isfinite(reach());
}

AffineForm::Multiplier AffineForm::multiplier(const arb_t x) {
  Multiplier result{loaded::arf_get_d(arb_midref(x), ARF_RND_NEAR)};
  Ball rounding;
  loaded::arb_set_d(rounding.get(), result.value);
  loaded::arb_sub(rounding.get(), x, rounding.get(), 64);
  result.error = largest(rounding.get());
  return result;
}

// A factor fl(fl(p f) + fl(q g)) errs by at most 2u(|p f| + |q g|), and the first order of u pays the second
// in three; where it underflows, by three of the least doubles.
AffineForm AffineForm::combined(AffineForm centre, Multiplier p, const AffineForm& x, Multiplier q,
                                const AffineForm& y, double second_order) {
  double sizes = 0;
  std::vector<Factor>& out = centre.factors_;
  out.reserve(x.factors_.size() + y.factors_.size());
  auto i = x.factors_.begin();
  auto j = y.factors_.begin();
  while (i != x.factors_.end() || j != y.factors_.end()) {
    const bool has_x = i != x.factors_.end() && (j == y.factors_.end() || i->symbol <= j->symbol);
    const bool has_y = j != y.factors_.end() && (i == x.factors_.end() || j->symbol <= i->symbol);
    const std::uint32_t symbol = has_x ? i->symbol : j->symbol;
    const double from_x = has_x ? p.value * i++->factor : 0;
    const double from_y = has_y ? q.value * j++->factor : 0;
    sizes += std::fabs(from_x) + std::fabs(from_y);
    if (const double factor = from_x + from_y; factor != 0) out.push_back({symbol, factor});
  }
  const double underflow = 3 * kLeast * static_cast<double>(x.factors_.size() + y.factors_.size());
  const double multipliers = p.error * x.reach() + q.error * y.reach();
  centre.add_error((3 * kUnit * sizes + multipliers + second_order + underflow) * kUp);
  return centre;
}

AffineForm operator+(const AffineForm& x, const AffineForm& y) {
  AffineForm sum(std::max(x.bits_, y.bits_));
  loaded::arb_add(sum.centre_, x.centre_, y.centre_, sum.bits_);
  return AffineForm::combined(std::move(sum), {1, 0}, x, {1, 0}, y, 0);
}

AffineForm operator-(const AffineForm& x, const AffineForm& y) {
  AffineForm difference(std::max(x.bits_, y.bits_));
  loaded::arb_sub(difference.centre_, x.centre_, y.centre_, difference.bits_);
  return AffineForm::combined(std::move(difference), {1, 0}, x, {-1, 0}, y, 0);
}

AffineForm operator-(const AffineForm& x) {
  return AffineForm(0, x.bits_) - x;
}

// (c + l)(d + m) = cd + d l + c m + l m, c and d in their balls.
AffineForm operator*(const AffineForm& x, const AffineForm& y) {
  AffineForm product(std::max(x.bits_, y.bits_));
  loaded::arb_mul(product.centre_, x.centre_, y.centre_, product.bits_);
  return AffineForm::combined(std::move(product), AffineForm::multiplier(y.centre_), x,
                              AffineForm::multiplier(x.centre_), y, x.reach() * y.reach());
}

// 1/(c + l) = 1/c − l/c² + l²/(c²(c + l)).
AffineForm inverse(const AffineForm& x) {
  AffineForm result(x.bits_);
  loaded::arb_inv(result.centre_, x.centre_, x.bits_);
  Ball slope(result.centre_), bend(x.alone().centre_);
  loaded::arb_pow_ui(slope.get(), slope.get(), 2, x.bits_);
  loaded::arb_neg(slope.get(), slope.get());
  loaded::arb_inv(bend.get(), bend.get(), x.bits_);
  loaded::arb_pow_ui(bend.get(), bend.get(), 3, x.bits_);
  const double second_order = x.reach() * x.reach() * largest(bend.get());
  return AffineForm::combined(std::move(result), AffineForm::multiplier(slope.get()), x, {},
                              AffineForm(x.bits_), second_order);
}

// √(c + l) = √c + l/(2√c) − l²/(2√c (√c + √(c + l))²), and the last term is at most l²/(8 w^(3/2)) for c, c +
// l ≥ w.
AffineForm sqrt(const AffineForm& x) {
  AffineForm result(x.bits_);
  loaded::arb_sqrt(result.centre_, x.centre_, x.bits_);
  Ball slope(result.centre_), bend(x.alone().centre_);
  loaded::arb_mul_2exp_si(slope.get(), slope.get(), 1);
  loaded::arb_inv(slope.get(), slope.get(), x.bits_);
  loaded::arb_rsqrt(bend.get(), bend.get(), x.bits_);
  loaded::arb_pow_ui(bend.get(), bend.get(), 3, x.bits_);
  const double second_order = x.reach() * x.reach() * largest(bend.get()) / 8;
  return AffineForm::combined(std::move(result), AffineForm::multiplier(slope.get()), x, {},
                              AffineForm(x.bits_), second_order);
}

AffineForm cos_degrees(double theta, long bits) {
  AffineForm result(theta, bits);
  loaded::arb_div_ui(result.centre_, result.centre_, 180, bits);
  loaded::arb_cos_pi(result.centre_, result.centre_, bits);
  return result;
}

AffineForm tan_degrees(double theta, long bits) {
  AffineForm result(theta, bits);
  loaded::arb_div_ui(result.centre_, result.centre_, 180, bits);
  loaded::arb_tan_pi(result.centre_, result.centre_, bits);
  return result;
}

AffineForm speed_ratio(double c, double theta_deg, long bits) {
  AffineForm result(c, bits), exponent(theta_deg, bits);
  loaded::arb_div_ui(exponent.centre_, exponent.centre_, 180, bits);
  loaded::arb_pow(result.centre_, result.centre_, exponent.centre_, bits);
  return result;
}

}  // namespace tps::cost
