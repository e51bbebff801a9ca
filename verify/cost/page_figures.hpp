// The figures of the page, each made from the JSON of a study.
#pragma once

#include <string>

#include "verify/cost/report.hpp"

namespace tps::cost {

/// Time against error on one stratum, and the front: the variants that no other beats in both.
std::string pareto_figure(const Json& study, const Json& stratum);

/// Which variants a figure has a line of.
struct Selection {
  std::string title;
  std::string formula;     ///< those of this formula, one colour an arithmetic; empty:
  std::string arithmetic;  ///< those in this arithmetic, one colour a formula
};

/// Share of wrong verdicts against the distance from tangency, on one stratum.
std::string tangency_figure(const Json& study, const Json& stratum, const Selection& selection);

/// The largest error against the condition number, with u times the condition number; over all strata but
/// those whose hazard is the range of numbers.
std::string condition_figure(const Json& study, const Selection& selection);

/// Numbers the formulas: series-0, series-1, … in the style sheet.
std::string series(const Json& study, const std::string& variant);

}  // namespace tps::cost
