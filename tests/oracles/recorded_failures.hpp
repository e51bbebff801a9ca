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
    {"50 digits", "wide", 2, 0},
    {"100 digits", "wide", 2, 0},
    {"GSL quadratic", "graze", 18, 0},
    {"GSL quadratic", "far", 14, 0},
    {"GSL quadratic", "any_scale", 47, 26},
    {"GSL quadratic", "wide", 8, 51},
    {"GSL quadratic", "subnormal", 78, 10},
    {"Brent", "graze", 1, 0},
    {"Brent", "touching", 2, 0},
    {"Brent", "tangent", 24, 0},
    {"Brent", "offset_origin", 1, 40},
    {"Brent", "near_static", 9, 63},
    {"Brent", "any_scale", 80, 31},
    {"Brent", "wide", 90, 9},
    {"Brent", "subnormal", 68, 55},
};

/// The n of GSL's wrong root counts for F(n) x² − 2F(n−1) x + F(n−2).
inline const std::vector<int> recorded_fibonacci = {43, 45, 47, 49, 51, 53, 55, 57, 59,
                                                    61, 63, 65, 67, 69, 71, 73, 75, 77};

}  // namespace tps::oracles
