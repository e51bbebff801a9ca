// Whether a particle is where one part of a box's outside is the nearest.
#pragma once

#include <algorithm>

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"

namespace tps::check {

enum class Within { no, rounding, yes };

/// Between two times of a flight: `yes` and `no` hold at all of them, beyond what the coordinates and the way
/// may be off by. Coordinates are linear in time, so that the ends decide. In double a difference and a
/// product a term and their sum err by 4u of the sizes.
template <typename Number>
Within in_region(const Context<Number>& c, const WallModel<Number>& wall, const PairFlight<Number>& flight,
                 const Work<Number>& from, const Work<Number>& until) {
  using W = Work<Number>;
  using std::abs;
  if (!wall.surface.region) return Within::yes;
  Within found = Within::yes;
  // The sign that the distance beyond an end has to have.
  const auto demand = [&](std::size_t k, const Number& end, int sign) {
    const W moved = W(end) + (W(flight.u_j[k]) - W(wall.point[k]));
    const W now = W(flight.u_i[k]) - moved, speed = W(flight.v_i[k]) - W(flight.v_j[k]);
    const W size = abs(W(flight.u_i[k])) + abs(W(end)) + abs(W(flight.u_j[k])) + abs(W(wall.point[k]));
    const auto beyond = [&](const W& t) { return W(sign) * (now + speed * t); };
    const W error =
        c.scale() * (W(4) * c.u() * (size + abs(speed) * until) + flight.blur) + c.model.precision.smallest;
    const W least = std::min(beyond(from), beyond(until)), most = std::max(beyond(from), beyond(until));
    const Within here = most < -error ? Within::no : least > error ? Within::yes : Within::rounding;
    found = std::min(found, here);
  };
  using Side = BoxRegion::Side;
  for (std::size_t k = 0; k < static_cast<std::size_t>(c.model.scene.dimension); ++k) {
    const Side side = wall.surface.region->sides[k];
    if (side != Side::above) demand(k, side == Side::below ? wall.low[k] : wall.high[k], -1);
    if (side != Side::below) demand(k, side == Side::above ? wall.high[k] : wall.low[k], 1);
  }
  return found;
}

}  // namespace tps::check
