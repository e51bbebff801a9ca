// A pair before and after a response, in wide numbers.
#pragma once

#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/lifted.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"

namespace tps::properties {

template <int D>
struct Response {
  Vector<Wide, D> r, before, after;  ///< relative position; relative velocity before and after
  Wide mu;
  Wide applied;  ///< what eq. (3) may add to `after`: 1u of Δp/m and of v' for each body
};

template <int D>
Response<D> respond(const Pair<D>& p, const Masses& m, const Vector<double, D>& dp) {
  const PairVelocities<double, D> v = apply_impulse<double, D>(m.A, m.B, p.v_A, p.v_B, dp);
  const Wide mu = wide_reduced_mass(m.A, m.B);
  return {wide<D>(p.u_B) - wide<D>(p.u_A), wide<D>(p.v_B) - wide<D>(p.v_A), wide<D>(v.v_B) - wide<D>(v.v_A),
          mu, u * (wide<D>(dp).norm() / mu + wide<D>(v.v_A).norm() + wide<D>(v.v_B).norm())};
}

}  // namespace tps::properties
