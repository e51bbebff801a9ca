// How a certified timing answer was reached, beside the one computed in double (`tps eval --why`).
#pragma once

#include "verify/certified/timing_input.hpp"
#include "verify/eval/report.hpp"

namespace tps::certified {

/// Steps: the coefficients of every stage that was asked, each with the bound on its error. Results:
/// certified verdict and time, what settled them, the double answer and its distance, the counters
/// (verify/exact/counters.hpp).
eval::Report why_time(const TimingInput& input);

/// The same for the order of two events; the double answer compares two computed times.
eval::Report why_order(const TimingInput& first, const TimingInput& second);

}  // namespace tps::certified
