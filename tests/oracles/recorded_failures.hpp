// Where each oracle is wrong, as data. Regenerate by running test_oracles: it prints each row that differs.
#pragma once

#include <string>
#include <vector>

namespace tps::oracles {

/// Of 200 queries of a stratum: how often an event was invented or missed, and how often its time was lost.
struct Failures {
  std::string oracle, stratum;
  int existence = 0;
  int time = 0;
};

/// Rows that are not here are 0, 0.
inline const std::vector<Failures> recorded_failures = {
    {"50 digits", "wide", 4, 0},
    {"100 digits", "wide", 3, 0},
    {"GSL quadratic", "graze", 12, 0},
    {"GSL quadratic", "far", 8, 0},
    {"GSL quadratic", "any_scale", 60, 20},
    {"GSL quadratic", "wide", 6, 62},
    {"GSL quadratic", "subnormal", 81, 13},
    {"Brent", "touching", 2, 0},
    {"Brent", "taut", 19, 0},
    {"Brent", "tangent", 29, 0},
    {"Brent", "offset_origin", 1, 43},
    {"Brent", "near_static", 5, 66},
    {"Brent", "any_scale", 78, 31},
    {"Brent", "wide", 92, 9},
    {"Brent", "subnormal", 75, 52},
    {"Brent", "graded_limit", 15, 0},
};

/// The n of GSL's wrong root counts for F(n) x² − 2F(n−1) x + F(n−2).
inline const std::vector<int> recorded_fibonacci = {43, 45, 47, 49, 51, 53, 55, 57, 59,
                                                    61, 63, 65, 67, 69, 71, 73, 75, 77};

}  // namespace tps::oracles
