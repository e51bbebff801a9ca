// What happened at one event: the content of a line of the trace.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
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

/// A field that events of one effect alone have: a whole number, a word, or numbers.
template <typename Scalar>
struct OwnField {
  std::string_view key;
  std::variant<std::int64_t, std::string_view, std::vector<Scalar>> value;
};

/// What some effects add to the record of an event, beside what every run has. One an effect, which keeps it
/// until its next event: a run that calls for none of them has a null pointer for all of it.
template <typename Scalar, int D>
struct Addition {
  std::optional<Vector<Scalar, D>> dv;         ///< gravity: of every finite mass
  std::optional<Vector<Scalar, D>> dp_stored;  ///< grouping: Δp_AB of eq. (7), at a load
  std::vector<int> members;                    ///< grouping: of the group after a load, ascending
  std::vector<SpinChange<Scalar>> spins;       ///< friction: of those of i and j that keep one
  std::optional<bool> sticks;                  ///< friction: whether the surfaces held each other
  std::optional<int> phase;                    ///< phases: which one
  std::optional<std::size_t> wall;             ///< walls: of the scene
  std::optional<int> face;                     ///< walls: of a box
  std::vector<OwnField<Scalar>> own;           ///< effects that a program brings along
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
  const Addition<Scalar, D>* addition = nullptr;  ///< until the effect's next event; null where it adds none
  TetherChange tether = TetherChange::none;
  std::optional<double> draw;  ///< uniform in [0, 1): the random number that decided `tether`

  std::uint64_t k = 0;  ///< number of the event, from 1
  Time<Scalar> t;       ///< since the start
  Scalar dt{};          ///< since the event before
};

}  // namespace tps
