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
};

struct NextEventInput {
  std::vector<GroupInput::Body> bodies;
  std::vector<PairLimit> limits;
};

struct CertifiedNextEvent {
  std::size_t limit;  ///< place in `limits`
  std::string kind;   ///< rebound, retract or revolve
  Enclosure dt;
  std::vector<EnclosedVector> positions, velocities;  ///< of every body, after the event
};

/// The timing query of one limit.
exact::TimingQuery timing_query(const NextEventInput& input, const PairLimit& limit);

/// The earliest event by exact order, its response, and the state after it: u + v dt and eq. (3).
///
/// REQUIRES vectors of 2 or 3 components. Absent where nothing happens, where two events are exactly
/// simultaneous, and where the kind is at the boundary: such a scene has no single answer.
std::optional<CertifiedNextEvent> certified_next_event(const NextEventInput& input);

}  // namespace tps::certified
