// How a certified timing answer was reached, beside the one computed in double (`tps eval --why`).
#pragma once

#include "verify/operations/report.hpp"
#include "verify/operations/timing_input.hpp"

namespace tps::certified {

/// Steps: the coefficients of every stage that was asked, each with the bound on its error. Results:
/// certified verdict and time, what settled them, the double answer and its distance, the counters
/// (verify/exact/counters.hpp).
operations::Report why_time(const operations::TimingInput& input);

/// The same for the order of two events; the double answer compares two computed times.
operations::Report why_order(const operations::TimingInput& first, const operations::TimingInput& second);

}  // namespace tps::certified
