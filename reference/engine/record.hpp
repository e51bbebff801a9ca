// What happened at one event: the content of a line of the trace.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "reference/engine/clock.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// A particle at an event. Its position is the same before and after: impulses act on velocities.
template <typename Scalar, int D>
struct ParticleChange {
  int particle;  ///< index
  Vector<Scalar, D> position, velocity_before, velocity_after;
};

/// The spin of a particle at an event: one number in the plane, three in space.
template <typename Scalar>
struct SpinChange {
  int particle;  ///< index
  std::vector<Scalar> before, after;
};

enum class TetherChange { none, formed, broken };

/// One event. `involved` starts with i and j (where there are two) and then holds the other members of the
/// bodies whose velocity changed; at a restitution it holds i and j alone, and every member is i or j of one
/// node.
template <typename Scalar, int D>
struct Record {
  std::string_view kind;
  int i = -1;  ///< indices; −1 where the event concerns no particle
  int j = -1;
  std::vector<ParticleChange<Scalar, D>> involved;
  std::optional<Vector<Scalar, D>>
      dp;  ///< Δp on i: of eq. (4) or (5), of eq. (7) at a restitution, J from outside
  std::optional<Vector<Scalar, D>> dv;  ///< of every finite mass, at an event that concerns all of them
  std::optional<Vector<Scalar, D>> dp_stored;  ///< Δp_AB of eq. (7), at a load
  std::vector<SpinChange<Scalar>> spins;       ///< of those of i and j that keep one, where friction acted
  std::optional<bool> sticks;                  ///< whether the surfaces held each other; where friction acted
  TetherChange tether = TetherChange::none;
  std::optional<double> draw;       ///< uniform in [0, 1): the random number that decided `tether`
  std::vector<int> members;         ///< of the group after a load, ascending; empty where nothing was loaded
  std::optional<int> detail;        ///< which phase, where `kind` is "phase"
  std::optional<std::size_t> wall;  ///< of the scene, where `kind` is "wall"
  std::optional<int> face;          ///< of a box

  std::uint64_t k = 0;  ///< number of the event, from 1
  Time<Scalar> t;       ///< since the start
  Scalar dt{};          ///< since the event before
};

}  // namespace tps
