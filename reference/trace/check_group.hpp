// Whether the loads of a body, as a full state has them, are a tree over its members.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "reference/trace/state_data.hpp"

namespace tps {

struct GroupProblem {
  std::string pointer;  ///< below the group's
  std::string message;
};

/// What is wrong with the members, nodes and masses, if anything. `mass_of` gives the mass of a particle.
///
/// A mass is the sum of those below it, added in some order: of n masses to n u/(1 − n u) of it, u =
/// 2^−digits the largest relative error of one of the n − 1 additions or of rounding a mass of the scene
/// (semantics §4, docs/trace.md). It is infinite where one of the particles below met an infinite mass.
/// REQUIRES that all particles named are known.
std::optional<GroupProblem> group_problem(const StateData::Group& group,
                                          const std::function<double(std::int32_t)>& mass_of, int digits);

/// What is wrong with the expiry of a body, if anything: a load, which is not after `now`, sets it to its own
/// time + dt, dt = dt_restitute. That sum is rounded to hi + lo in our runs, by 2 u² (t + dt) (after() in
/// engine/clock.hpp; 4 u² here, since t and hi differ by u t), and to one number by other programs; dt itself
/// to a number of the scalar.
std::optional<std::string> expiry_problem(const HexTime& expiry, const HexTime& now, double dt, int digits,
                                          bool of_our_run);

}  // namespace tps
