// Four doubles in one register of AVX2, with the operations of the filters' formulas: each of the four
// results is rounded as that of one double is. For sources that are compiled with -mavx2 -mfma; elsewhere
// there is nothing here.
#pragma once

#if defined(__AVX2__) && defined(__FMA__)

#include <immintrin.h>

#include "verify/exact/double_word.hpp"

namespace tps::exact {

/// For each of the four whether it is so, all bits set or none.
struct FourTruths {
  __m256d bits;

  TPS_IN_EVERY_COPY friend FourTruths operator&(FourTruths x, FourTruths y) {
    return {_mm256_and_pd(x.bits, y.bits)};
  }
  TPS_IN_EVERY_COPY friend FourTruths both(FourTruths x, FourTruths y) { return x & y; }
  TPS_IN_EVERY_COPY friend FourTruths operator|(FourTruths x, FourTruths y) {
    return {_mm256_or_pd(x.bits, y.bits)};
  }
  /// Bit k of the number is the truth of the k-th.
  TPS_IN_EVERY_COPY unsigned mask() const { return static_cast<unsigned>(_mm256_movemask_pd(bits)); }
};

struct Four {
  __m256d lanes;

  Four() = default;
  TPS_IN_EVERY_COPY Four(__m256d four) : lanes(four) {}
  TPS_IN_EVERY_COPY Four(double x) : lanes(_mm256_set1_pd(x)) {}
  TPS_IN_EVERY_COPY explicit Four(const double (&four)[4]) : lanes(_mm256_loadu_pd(four)) {}
  TPS_IN_EVERY_COPY void store(double (&four)[4]) const { _mm256_storeu_pd(four, lanes); }

  TPS_IN_EVERY_COPY friend Four operator+(Four x, Four y) { return _mm256_add_pd(x.lanes, y.lanes); }
  TPS_IN_EVERY_COPY friend Four operator-(Four x, Four y) { return _mm256_sub_pd(x.lanes, y.lanes); }
  TPS_IN_EVERY_COPY friend Four operator*(Four x, Four y) { return _mm256_mul_pd(x.lanes, y.lanes); }
  TPS_IN_EVERY_COPY friend Four operator/(Four x, Four y) { return _mm256_div_pd(x.lanes, y.lanes); }
  TPS_IN_EVERY_COPY friend Four operator-(Four x) { return _mm256_xor_pd(x.lanes, _mm256_set1_pd(-0.0)); }

  TPS_IN_EVERY_COPY friend FourTruths operator<(Four x, Four y) {
    return {_mm256_cmp_pd(x.lanes, y.lanes, _CMP_LT_OQ)};
  }
  TPS_IN_EVERY_COPY friend FourTruths operator>(Four x, Four y) { return y < x; }
  TPS_IN_EVERY_COPY friend FourTruths operator==(Four x, Four y) {
    return {_mm256_cmp_pd(x.lanes, y.lanes, _CMP_EQ_OQ)};
  }

  TPS_IN_EVERY_COPY friend Four multiply_add(Four x, Four y, Four z) {
    return _mm256_fmadd_pd(x.lanes, y.lanes, z.lanes);
  }
  TPS_IN_EVERY_COPY friend Four absolute(Four x) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), x.lanes); }
  TPS_IN_EVERY_COPY friend Four square_root(Four x) { return _mm256_sqrt_pd(x.lanes); }
  TPS_IN_EVERY_COPY friend Four either(FourTruths first, Four x, Four y) {
    return _mm256_blendv_pd(y.lanes, x.lanes, first.bits);
  }
};

}  // namespace tps::exact

#endif
