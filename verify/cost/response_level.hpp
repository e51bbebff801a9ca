// Eqs. (4), (5) and (7), and the choice between (4) and (5), in each scalar, against certified enclosures
// (verify/certified).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/cost/run_level.hpp"
#include "verify/operations/catalogue.hpp"

namespace tps::cost {

/// The numbers of one response; what an equation does not have is zero.
struct ResponseQuestion {
  double u_A[3], u_B[3], v_A[3], v_B[3], dp[3];
  double m_A, m_B, c, c_retract, c_revolve, theta_revolve_deg;
};

/// What a scalar answers, rounded to double where it is wider, and taken from the enclosure where it is not.
struct ResponseAnswer {
  double impulse[3];
  bool revolves = false;  ///< of tether_response
};

/// One equation in one scalar.
struct ResponseVariant {
  operations::Op op;
  std::string scalar;
  int bits;
  ResponseAnswer (*answer)(const ResponseQuestion&);
  void (*throughput)(std::span<const ResponseQuestion>);
};

/// collision_impulse, revolution_impulse, restitution_impulse and tether_response, in float, double, long
/// double, quad, mp50 and mp100: response_variants.cpp.
std::vector<ResponseVariant> response_variants();

/// An equation in a scalar on a stratum of its known answers.
struct ResponseRow {
  std::string op, stratum, scalar;
  int bits = 0;
  std::uint64_t asked = 0;
  std::uint64_t other_kind = 0;  ///< retracts where it should revolve, or the reverse; boundaries not counted
  std::uint64_t lost = 0;        ///< no finite number: beyond the range of the scalar
  std::uint64_t off = 0;         ///< a component, as a double, lies outside of its enclosure; of the others
  /// log2 |Δp̂ − Δp| / |Δp| of the others, Δp being rounded to double, where it is not zero; told for float
  /// and double, since what is closer than that is not seen.
  std::optional<double> log2_p50, log2_p99, log2_max;
  double ns = 0;  ///< a question: median over the repetitions
};

struct ResponseLevel {
  std::uint64_t seed = 1;
  int questions = 0;  ///< of a stratum
  std::vector<ResponseRow> rows;
};

struct ResponseLevelOptions {
  std::uint64_t seed = 1;
  int questions = 200;
  int repetitions = 5;
  std::vector<std::string> parts;  ///< of response_parts(); empty: all
  Announce announce = [](const std::string&) {};
};

/// "collision_impulse, plain": an equation on a stratum of its known answers.
std::vector<std::string> response_parts();

ResponseLevel measure_responses(const ResponseLevelOptions& options);

}  // namespace tps::cost
