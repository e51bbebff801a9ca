// Integers and fractions of any size. Heavy header: only sources of this folder include it.
#pragma once

#ifdef __EMSCRIPTEN__
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif

#include "verify/exact/verdict.hpp"

namespace tps::certified {

using exact::Sign;

// GMP's, or Boost's own where there is no GMP (pages): the same numbers, a fraction of the time.
#ifdef __EMSCRIPTEN__
using IntegerBackend = boost::multiprecision::cpp_int_backend<>;
using RationalBackend = boost::multiprecision::cpp_rational_backend;
#else
using IntegerBackend = boost::multiprecision::gmp_int;
using RationalBackend = boost::multiprecision::gmp_rational;
#endif

// Without expression templates: `auto` and `?:` then mean what they say.
using Integer = boost::multiprecision::number<IntegerBackend, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<RationalBackend, boost::multiprecision::et_off>;

}  // namespace tps::certified
