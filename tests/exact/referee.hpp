// What the answers must be, from rationals and 1500 digits. Shares no code with verify/exact/.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>
#include <string>

#include "verify/exact/timing_query.hpp"

namespace tps::exact::referee {

using Rational = boost::multiprecision::cpp_rational;
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<1500>>;

/// a, h, c, D of the stored doubles.
struct Quadratic {
  Rational a, h, c, D;
};
Quadratic quadratic(const TimingQuery& query);

/// The verdict's name by the tables of semantics §1.
std::string verdict(const TimingQuery& query);
std::string verdict(const TimingQuery& query, const Quadratic& exact);

/// The time to 1500 digits; absent where there is no event.
std::optional<Wide> time(const TimingQuery& query);

}  // namespace tps::exact::referee
