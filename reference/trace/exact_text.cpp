#include "reference/trace/exact_text.hpp"

#include <charconv>
#include <cmath>

#include "reference/text/number_text.hpp"

namespace tps {
namespace {

HexDigits digits_of(const Hex& text) {
  return split_hex(text).value();
}

HexDigits negated(HexDigits x) {
  x.negative = !x.negative;
  return x;
}

HexDigits magnitude(HexDigits x) {
  x.negative = false;
  return x;
}

/// The exponent e of the leading bit: 2^e <= |x| < 2^(e+1). REQUIRES not zero.
long leading_exponent(const HexDigits& x) {
  const HexDigits first{false, x.digits.substr(0, 1), 0};
  const int bits = first.digits >= "8" ? 3 : first.digits >= "4" ? 2 : first.digits >= "2" ? 1 : 0;
  return x.exponent + 4 * static_cast<long>(x.digits.size() - 1) + bits;
}

bool is_count(const Hex& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= 0;
}

}  // namespace

int sign_of_sum(const std::vector<HexDigits>& terms) {
  const HexDigits sum = exact_sum(terms);
  return sum.digits.empty() ? 0 : sum.negative ? -1 : 1;
}

bool is_not_after(const HexTime& a, const HexTime& b) {
  if (a == b) return true;
  // Normal times are in the order of their his, or equal: |lo| is at most half an ulp.
  const HexFloat hi_a = parse_hex_float(a[0]);
  const HexFloat hi_b = parse_hex_float(b[0]);
  const bool doubles = hi_a.verdict == HexFloat::Verdict::exact && hi_b.verdict == HexFloat::Verdict::exact;
  if (doubles && hi_a.value < hi_b.value) return true;
  return sign_of_sum(
             {digits_of(a[0]), digits_of(a[1]), negated(digits_of(b[0])), negated(digits_of(b[1]))}) <= 0;
}

bool is_not_after_sum(const HexTime& a, const HexTime& b, double dt, int digits, int sum_digits) {
  const auto lowered = [](HexDigits x, int by) {
    x.exponent -= by;
    return x;
  };
  const HexDigits hi = negated(digits_of(b[0])), delay = negated(hex_digits(dt));
  return sign_of_sum({digits_of(a[0]), digits_of(a[1]), hi, negated(digits_of(b[1])), delay,
                      lowered(delay, digits), lowered(hi, sum_digits), lowered(delay, sum_digits)}) <= 0;
}

bool is_normal_time(const HexTime& time, int digits) {
  constexpr int kOfDouble = 53;
  const HexFloat quick_hi = parse_hex_float(time[0]);
  const HexFloat quick_lo = parse_hex_float(time[1]);
  const bool doubles =
      quick_hi.verdict == HexFloat::Verdict::exact && quick_lo.verdict == HexFloat::Verdict::exact;
  if (doubles && digits <= kOfDouble && quick_hi.value > 0x1p-900)  // all exact: far from underflow
    return std::fabs(quick_lo.value) <= std::ldexp(1.0, std::ilogb(quick_hi.value) - digits);
  const HexDigits hi = digits_of(time[0]);
  const HexDigits lo = digits_of(time[1]);
  if (hi.negative && !hi.digits.empty()) return false;
  if (hi.digits.empty() || lo.digits.empty()) return lo.digits.empty();
  // Half an ulp is 2^(e − digits), below a power of two half of that again.
  HexDigits half{true, "1", leading_exponent(hi) - digits};
  return sign_of_sum({magnitude(lo), half}) <= 0;
}

bool is_sum(const Hex& t, double start_time, const HexTime& time) {
  return sign_of_sum({digits_of(t), negated(hex_digits(start_time)), negated(digits_of(time[0])),
                      negated(digits_of(time[1]))}) == 0;
}

bool is_observation(const std::vector<Hex>& observation) {
  constexpr std::size_t kBeforeSizes = 11;
  if (observation.size() < kBeforeSizes) return false;
  for (std::size_t n = 1; n < observation.size(); ++n) {
    const bool counts = n == 2 || n == 6 || n >= kBeforeSizes;
    if (counts ? !is_count(observation[n]) : !from_hex<double>(observation[n]).has_value()) return false;
  }
  return true;
}

}  // namespace tps
