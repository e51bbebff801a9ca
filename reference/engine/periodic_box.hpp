// A periodic box: which image of a partner is the nearest, and for how long it is the only one that can be
// met.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "reference/engine/clock.hpp"
#include "reference/equations/periodic_image.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// The largest distance at which two particles of a scene have an event.
inline double longest_interaction(const Scene& scene) {
  double longest = 0;
  for (const PairLaw& law : scene.pairs) {
    if (law.blocking) longest = std::max(longest, law.blocking->distance);
    if (law.tethering) longest = std::max(longest, law.tethering->distance);
  }
  return longest;
}

/// In the engine's scalar. With W an edge and L the longest interaction: while a partner's nearest image is
/// at |r_k| ≤ W/2, any other one is at W/2 at least along some axis; it cannot be met before the two have
/// moved by W/2 − L relative to each other along that axis.
template <typename Scalar, int D>
class PeriodicBox {
 public:
  using Vec = Vector<Scalar, D>;

  explicit PeriodicBox(const Scene& scene) {
    const double L = longest_interaction(scene);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < D; ++k) {
      const double edge = scene.box->edges[static_cast<std::size_t>(k)];
      const bool open = !(edge < std::numeric_limits<double>::infinity());
      edges_[k] = open ? Scalar(0) : Scalar(edge);
      // A 64th is for the rounding of places, which knows() bounds.
      const double room = open ? edge : (edge / 2 - L) * (63. / 64);
      room_[k] = Scalar(room);
      per_edge_[k] = open ? Scalar(0) : Scalar(1) / edges_[k];
      nearly_half_[k] = open ? std::numeric_limits<Scalar>::infinity() : Scalar(0.49) * edges_[k];
      least = std::min(least, room);
    }
    farthest_ = Scalar(least / 512) / std::numeric_limits<Scalar>::epsilon();
  }

  /// Whether coordinates are still known to a 64th of the room: eight roundings of them lead to a difference.
  bool knows(const Vec& u) const {
    bool all = true;
    for (int k = 0; k < D; ++k) all = all && knows(u[k]);
    return all;
  }
  bool knows(const Scalar& coordinate) const {
    using std::abs;
    return abs(coordinate) < farthest_;
  }

  /// The image of j that is nearest to i, along each axis for itself; of two, either.
  PeriodicImage<Scalar, D> nearest(const Vec& u_i, const Vec& u_j) const {
    PeriodicImage<Scalar, D> image{Vec::Zero(), edges_};
    for (int k = 0; k < D; ++k) {
      if (edges_[k] != Scalar(0)) image.n[k] = number(k, Scalar(u_j[k] - u_i[k]));
    }
    return image;
  }
  /// Brings a difference of places that are known to the image that is nearest, |r| ≤ W/2.
  /// @return whether that is certain: by 1 % of W.
  bool bring_near(int k, Scalar& r) const {
    using std::abs;
    // An integer from here on has no digits behind its point.
    constexpr Scalar whole = Scalar(1.5) / std::numeric_limits<Scalar>::epsilon();
    r -= ((r * per_edge_[k] + whole) - whole) * edges_[k];
    return abs(r) < nearly_half_[k];
  }

  /// Until when only the image that is nearest at t can be met, by a pair of the relative velocity v.
  Time<Scalar> holds_until(const Time<Scalar>& t, const Vec& v) const {
    using std::abs;
    Scalar dt = std::numeric_limits<Scalar>::infinity();
    for (int k = 0; k < D; ++k) {
      if (edges_[k] != Scalar(0) && v[k] != Scalar(0)) dt = std::min(dt, Scalar(room_[k] / abs(v[k])));
    }
    return after(t, dt);
  }

  const Vec& edges() const { return edges_; }  ///< 0 along an open axis
  /// Coordinates from here on are not known.
  const Scalar& farthest() const { return farthest_; }

 private:
  Scalar number(int k, const Scalar& r) const {
    return Scalar(-floored(Scalar(r / edges_[k] + Scalar(0.5))));
  }
  /// ⌊x⌋; in numbers of the hardware without a call of the library, |x| being far below 2⁶³.
  static Scalar floored(const Scalar& x) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      const auto towards_zero = static_cast<Scalar>(static_cast<std::int64_t>(x));
      return towards_zero - (x < towards_zero ? Scalar(1) : Scalar(0));
    } else {
      using std::floor;
      return floor(x);
    }
  }

  Vec edges_, room_, per_edge_, nearly_half_;
  Scalar farthest_;
};

}  // namespace tps
