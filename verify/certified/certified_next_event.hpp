// The certified next event of particles that fly freely: who, when, and where all are afterwards.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verify/certified/certified_response.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::certified {

/// One way in which two of the bodies can meet: a limit of their pair law.
struct PairLimit {
  std::size_t i, j;  ///< places in `bodies`
  exact::Kind kind;
  double L;
  double c;  ///< c_rebound or c_retract
  double c_revolve = 0, theta_revolve_deg = 0;
  bool forms = false;                       ///< a tether, at a blocking collision
  bool breaks = false;                      ///< the tether, at a tethering collision
  std::optional<double> breaks_above = {};  ///< … where |Δp| is above it
};

struct NextEventInput {
  std::vector<operations::GroupInput::Body> bodies;
  std::vector<PairLimit> limits;  ///< of simultaneous ones the first in this order happens
  bool grouped = false;           ///< a collision loads: both take v_load, eq. (6)
};

struct CertifiedNextEvent {
  std::size_t limit;   ///< place in `limits`
  std::string kind;    ///< rebound, retract, revolve or break
  std::string tether;  ///< formed, broken; empty where neither
  Enclosure dt;
  std::vector<EnclosedVector> positions, velocities;  ///< of every body, after the event
  bool tied = false;                                  ///< another event is at exactly the same time
  bool boundary =
      false;  ///< |c_retract v_n| = tan θ |v_ŵ| or |Δp| = the threshold: either kind is acceptable
  bool settled = true;  ///< every number is proven to be the nearest double
};

/// The timing query of one limit.
exact::TimingQuery timing_query(const NextEventInput& input, const PairLimit& limit);

/// The earliest event by exact order, its response, and the state after it: u + v dt and eq. (3). Takes time
/// linear in the limits.
///
/// REQUIRES vectors of one dimension, 2 or 3, and positions that differ. Absent where nothing ever happens.
std::optional<CertifiedNextEvent> certified_next_event(const NextEventInput& input);

}  // namespace tps::certified
