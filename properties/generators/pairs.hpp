// Pairs of particles about to meet a limit, most of them at an edge of the verdict tables.
#pragma once

#include <rapidcheck.h>

#include <iosfwd>

#include "reference/equations/vector.hpp"

namespace tps::properties {

/// What a generated pair was aimed at; rounding may put it on either side.
enum class Aim { general, graze, touch, taut, head_on, static_pair };

/// Two particles and a limiting distance.
template <int D>
struct Pair {
  Aim aim = Aim::general;
  Vector<double, D> u_A, u_B, v_A, v_B;
  double L = 1;

  Vector<double, D> r() const { return u_B - u_A; }
  Vector<double, D> v() const { return v_B - v_A; }
};

template <int D>
std::ostream& operator<<(std::ostream& out, const Pair<D>& pair);

/// Any vector of number().
template <int D>
rc::Gen<Vector<double, D>> vector();

/// A pair aimed at each of the edges in turn.
template <int D>
rc::Gen<Pair<D>> pair();

/// A pair whose positions differ, and whose relative velocity across the axis is at least 1e-3 of the whole.
template <int D>
rc::Gen<Pair<D>> turning_pair();

}  // namespace tps::properties
