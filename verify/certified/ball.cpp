#include "verify/certified/ball.hpp"

#include "verify/certified/arb_functions.hpp"

namespace tps::certified {
namespace {

/// An integer of FLINT.
class Flint {
 public:
  Flint() { loaded::fmpz_init(x_); }
  explicit Flint(const Integer& x) : Flint() { loaded::fmpz_set_mpz(x_, x.backend().data()); }
  ~Flint() { loaded::fmpz_clear(x_); }
  Flint(const Flint&) = delete;
  Flint& operator=(const Flint&) = delete;

  fmpz* get() { return x_; }
  Integer integer() const {
    Integer result;
    loaded::fmpz_get_mpz(result.backend().data(), x_);
    return result;
  }

 private:
  fmpz_t x_;
};

}  // namespace

struct Ball::Arb {
  Arb() {
    loaded::OfThisThread::keep();
    loaded::arb_init(x);
  }
  ~Arb() { loaded::arb_clear(x); }
  Arb(const Arb&) = delete;
  Arb& operator=(const Arb&) = delete;
  arb_t x;
};

Ball::Ball() : arb_(std::make_shared<Arb>()) {}

Ball::Ball(const Rational& x) : Ball() {
  Flint n(numerator(x)), d(denominator(x));
  loaded::arb_fmpz_div_fmpz(arb_->x, n.get(), d.get(), WorkingPrecision::bits());
}

Ball::Ends Ball::ends() const {
  if (loaded::arb_is_finite(arb_->x) == 0) {
    WorkingPrecision::doubt();
    const Rational beyond_doubles(Integer(1) << 1100U);
    return {-beyond_doubles, beyond_doubles};
  }
  Flint lo, hi, exponent;
  loaded::arb_get_interval_fmpz_2exp(lo.get(), hi.get(), exponent.get(), arb_->x);
  const slong shift = loaded::fmpz_get_si(exponent.get());
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(shift));
  const auto end = [&](const Flint& x) {
    return shift >= 0 ? Rational(x.integer() * power) : Rational(x.integer(), power);
  };
  return {end(lo), end(hi)};
}

Sign Ball::sign() const {
  if (loaded::arb_is_positive(arb_->x) != 0) return Sign::positive;
  if (loaded::arb_is_negative(arb_->x) != 0) return Sign::negative;
  WorkingPrecision::doubt();
  return Sign::uncertain;
}

Ball operator+(const Ball& x, const Ball& y) {
  Ball sum;
  loaded::arb_add(sum.arb_->x, x.arb_->x, y.arb_->x, WorkingPrecision::bits());
  return sum;
}

Ball operator*(const Ball& x, const Ball& y) {
  Ball product;
  loaded::arb_mul(product.arb_->x, x.arb_->x, y.arb_->x, WorkingPrecision::bits());
  return product;
}

Ball operator/(const Ball& x, const Ball& y) {
  Ball quotient;
  loaded::arb_div(quotient.arb_->x, x.arb_->x, y.arb_->x, WorkingPrecision::bits());
  return quotient;
}

Ball sqrt(const Ball& x) {
  Ball root;
  loaded::arb_sqrtpos(root.arb_->x, x.arb_->x, WorkingPrecision::bits());
  return root;
}

Ball cos_squared_pi(const Ball& x) {
  Ball cosine;
  loaded::arb_cos_pi(cosine.arb_->x, x.arb_->x, WorkingPrecision::bits());
  return cosine * cosine;
}

Ball pow(const Ball& x, const Ball& y) {
  Ball power;
  loaded::arb_pow(power.arb_->x, x.arb_->x, y.arb_->x, WorkingPrecision::bits());
  return power;
}

}  // namespace tps::certified
