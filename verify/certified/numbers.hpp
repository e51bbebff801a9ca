// Integers and fractions of any size. Heavy header: only sources of this folder include it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "verify/exact/verdict.hpp"

namespace tps::certified {

using exact::Sign;

// Without expression templates: `auto` and `?:` then mean what they say.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

}  // namespace tps::certified
