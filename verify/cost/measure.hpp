// The measurement of one stratum: accuracy first, then times, interleaved.
#pragma once

#include "verify/cost/questions.hpp"
#include "verify/cost/study.hpp"
#include "verify/cost/variant.hpp"

namespace tps::cost {

/// Verdicts and errors of the variants on the questions, against exact answers. Deterministic.
StratumResult measure_accuracy(const Hazard& stratum, const StudyOptions& options,
                               const std::vector<Variant>& variants);

/// Adds times to the result's cells: in each repetition every variant once, in an order of its own.
void measure_times(StratumResult& result, const StudyOptions& options, const std::vector<Variant>& variants);

}  // namespace tps::cost
