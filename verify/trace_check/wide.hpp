// The numbers of traces wider than double. Heavy header: only sources of this folder include it.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "reference/equations/wide_square_root.hpp"

namespace tps::check {

/// 833 bits: hi + lo of mp100, whose numbers have 334, fits exactly.
using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<250>, boost::multiprecision::et_off>;

}  // namespace tps::check
