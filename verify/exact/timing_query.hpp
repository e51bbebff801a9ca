// The question, in the words of the reference: two stored states, a limit, and which kind of limit it is.
#pragma once

#include "reference/equations/timing_query.hpp"

namespace tps::exact {

using tps::is_static;
using tps::Moment;
using tps::TimingQuery;
using tps::valid;
using Kind = TimingKind;
using Vec3 = std::array<double, 3>;

}  // namespace tps::exact
