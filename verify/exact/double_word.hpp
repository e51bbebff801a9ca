// Double words: unevaluated sums hi + lo of two doubles, |lo| ≤ ulp(hi)/2, about 106 bits.
//
// Algorithms and bounds of Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic", ACM TOMS 44(2), 2017. Bounds hold while nothing over- or underflows.
#pragma once

#include <cmath>

// On x86-64 fma is an instruction of newer processors and a slow function elsewhere: functions so marked are
// compiled for both and chosen when the program starts. The results are the same. Sanitizers cannot
// instrument the choice, and without optimisation nothing is inlined into the copies.
//
// What such a function calls has to be part of its copies: out of line it would be compiled once, for every
// processor, and call the slow function.
#if defined(__x86_64__) && defined(__linux__) && defined(__OPTIMIZE__) && !defined(TPS_SANITIZED)
#define TPS_WITH_FMA __attribute__((target_clones("fma", "default")))
#else
#define TPS_WITH_FMA
#endif
#define TPS_IN_EVERY_COPY [[gnu::always_inline]] inline

namespace tps::exact {

struct DoubleWord {
  double hi, lo;
};

/// x + y exactly (Knuth's TwoSum). Exact in the presence of underflow, too.
TPS_IN_EVERY_COPY DoubleWord two_sum(double x, double y) {
  const double sum = x + y;
  const double y_part = sum - x;
  const double x_part = sum - y_part;
  return {sum, (x - x_part) + (y - y_part)};
}

/// x + y exactly. REQUIRES |x| ≥ |y| or x = 0 (Dekker's Fast2Sum).
TPS_IN_EVERY_COPY DoubleWord fast_two_sum(double x, double y) {
  const double sum = x + y;
  return {sum, y - (sum - x)};
}

/// x·y exactly, by fma.
TPS_IN_EVERY_COPY DoubleWord two_product(double x, double y) {
  const double product = x * y;
  return {product, __builtin_fma(x, y, -product)};
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
  const double cross = __builtin_fma(x.hi, y.lo, x.lo * y.hi);
  return fast_two_sum(high.hi, high.lo + cross);
}

/// x·y with a double y, relative error ≤ 2u² (DWTimesFP3).
TPS_IN_EVERY_COPY DoubleWord operator*(DoubleWord x, double y) {
  const DoubleWord high = two_product(x.hi, y);
  return fast_two_sum(high.hi, __builtin_fma(x.lo, y, high.lo));
}

}  // namespace tps::exact
