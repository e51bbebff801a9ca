// Double words: unevaluated sums hi + lo of two doubles, |lo| ≤ ulp(hi)/2, about 106 bits.
//
// Algorithms and bounds of Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic", ACM TOMS 44(2), 2017. Bounds hold while nothing over- or underflows.
#pragma once

#include "verify/exact/in_every_copy.hpp"

namespace tps::exact {

/// Of double, or of several doubles at once (four_doubles.hpp).
template <typename T>
struct Words {
  T hi, lo;
};
using DoubleWord = Words<double>;

/// x y + z, rounded once.
TPS_IN_EVERY_COPY double multiply_add(double x, double y, double z) {
  return __builtin_fma(x, y, z);
}

/// x + y exactly (Knuth's TwoSum). Exact in the presence of underflow, too.
template <typename T>
TPS_IN_EVERY_COPY Words<T> two_sum(T x, T y) {
  const T sum = x + y;
  const T y_part = sum - x;
  const T x_part = sum - y_part;
  return {sum, (x - x_part) + (y - y_part)};
}

/// x + y exactly. REQUIRES |x| ≥ |y| or x = 0 (Dekker's Fast2Sum).
TPS_IN_EVERY_COPY DoubleWord fast_two_sum(double x, double y) {
  const double sum = x + y;
  return {sum, y - (sum - x)};
}

/// x·y exactly, by fma.
template <typename T>
TPS_IN_EVERY_COPY Words<T> two_product(T x, T y) {
  const T product = x * y;
  return {product, multiply_add(x, y, -product)};
}

/// x + y, relative error ≤ 3u² + 13u³ (AccurateDWPlusDW).
TPS_IN_EVERY_COPY DoubleWord operator+(DoubleWord x, DoubleWord y) {
  const DoubleWord high = two_sum(x.hi, y.hi);
  const DoubleWord low = two_sum(x.lo, y.lo);
  const DoubleWord sum = fast_two_sum(high.hi, high.lo + low.hi);
  return fast_two_sum(sum.hi, low.lo + sum.lo);
}

TPS_IN_EVERY_COPY DoubleWord operator-(DoubleWord x) {
  return {-x.hi, -x.lo};
}
TPS_IN_EVERY_COPY DoubleWord operator-(DoubleWord x, DoubleWord y) {
  return x + (-y);
}

/// x·y, relative error ≤ 5u² (DWTimesDW2).
TPS_IN_EVERY_COPY DoubleWord operator*(DoubleWord x, DoubleWord y) {
  const DoubleWord high = two_product(x.hi, y.hi);
  const double cross = multiply_add(x.hi, y.lo, x.lo * y.hi);
  return fast_two_sum(high.hi, high.lo + cross);
}

/// x·y with a double y, relative error ≤ 2u² (DWTimesFP3).
TPS_IN_EVERY_COPY DoubleWord operator*(DoubleWord x, double y) {
  const DoubleWord high = two_product(x.hi, y);
  return fast_two_sum(high.hi, multiply_add(x.lo, y, high.lo));
}

}  // namespace tps::exact
