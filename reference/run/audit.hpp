// Every distance bound of a scene, looked at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/engine/response.hpp"
#include "reference/engine/wall_surface.hpp"
#include "reference/engine/world.hpp"
#include "reference/scene/point_tree.hpp"

namespace tps {

/// The most that any pair, or any particle and a wall, is nearer than its inner or farther than its outer
/// limit, in ulps of their largest coordinate; zero where none is.
template <typename Scalar>
struct BoundExcess {
  Scalar inner{0};
  Scalar outer{0};
};

namespace detail {

/// Looks at every pair that a tree of positions in double cannot clear: O(N log N) while few are near.
template <typename Scalar, int D>
class Audit {
 public:
  Audit(const World<Scalar, D>& world, const Time<Scalar>& t)
      : world_(world), time_(t), places_(world.scene) {
    using std::abs;
    for (int i = 0; i < world.size(); ++i) {
      at_.push_back(world.position(i, t));
      Coordinates& place = places_.particles[world.index(i)].position;
      for (int k = 0; k < D; ++k) {
        place[static_cast<std::size_t>(k)] = static_cast<double>(at_.back()[k]);
        if (world.box) {
          const double edge = static_cast<double>(world.box->edges()[k]);
          double& x = place[static_cast<std::size_t>(k)];
          if (edge > 0) x -= std::floor(x / edge) * edge;
        }
        farthest_ = std::max(farthest_, std::fabs(place[static_cast<std::size_t>(k)]));
      }
    }
  }

  BoundExcess<Scalar> excess() {
    for (const PairLaw& law : world_.scene.pairs) judge(law);
    for (int i = 0; i < world_.size(); ++i) {
      for (const int j : world_.tethers.of(i)) {
        if (i < j) look_at(i, j);
      }
    }
    for (const Surface& surface : surfaces(world_.scene))
      look_at(WallSurface<Scalar, D>(surface, world_.scene));
    return worst_;
  }

 private:
  /// What a wider scalar loses when its positions become doubles is far below the widening of the limits.
  void judge(const PairLaw& law) {
    if (is_never_followed(world_.scene, law)) return;
    const bool permanent = law.tethering && law.tethering->form.when == FormRule::When::permanent;
    const std::vector<std::size_t> a = members(law.species_a);
    const PointTree b(places_, members(law.species_b));
    const bool all = !(farthest_ < 0x1p500);
    for (const std::size_t i : a)
      visit_images(places_.particles[i].position, [&](const Coordinates& place) {
        const auto worth = [&](const PointTree::Box& box) {
          const double slack = 0x1p-48 * farthest_;
          return all ||
                 (law.blocking &&
                  may_be_nearer(box, place, law.blocking->distance * (1 + 0x1p-20) + slack)) ||
                 (permanent && may_be_farther(box, place,
                                              std::max(law.tethering->distance * (1 - 0x1p-20) - slack,
                                                       law.tethering->distance / 2)));
        };
        b.visit(worth, [&](std::size_t j) {
          if (i != j) look_at(static_cast<int>(std::min(i, j)), static_cast<int>(std::max(i, j)));
        });
      });
  }

  /// A place, and in a periodic box its images around.
  template <typename Visit>
  void visit_images(const Coordinates& place, Visit visit) const {
    if (!world_.box) return visit(place);
    for (int n = 0; n < (D == 3 ? 27 : 9); ++n) {
      Coordinates image = place;
      bool is_one = true;
      int digits = n;
      for (int k = 0; k < D; ++k, digits /= 3) {
        const double edge = static_cast<double>(world_.box->edges()[k]);
        is_one = is_one && (edge > 0 || digits % 3 == 1);
        image[static_cast<std::size_t>(k)] += (digits % 3 - 1) * edge;
      }
      if (is_one) visit(image);
    }
  }

  std::vector<std::size_t> members(int species) const {
    std::vector<std::size_t> members;
    for (int i = 0; i < world_.size(); ++i) {
      if (world_.species(i) == species) members.push_back(world_.index(i));
    }
    return members;
  }

  void look_at(int i, int j) {
    const Law<Scalar>& law = world_.law(i, j);
    const Vector<Scalar, D>& u_i = at_[world_.index(i)];
    const Vector<Scalar, D>& u_j = at_[world_.index(j)];
    const Scalar distance = norm<Scalar, D>(world_.box ? world_.box->nearest(u_i, u_j).difference(u_i, u_j)
                                                       : Vector<Scalar, D>(u_j - u_i));
    const bool inside = law.blocking && distance < law.blocking->distance;
    const bool outside = world_.tethered(i, j) && distance > law.tethering->distance;
    if (!inside && !outside) return;
    const Scalar ulp = coordinate_ulp<Scalar, D>(u_i, u_j);
    if (inside) worst_.inner = std::max(worst_.inner, Scalar((law.blocking->distance - distance) / ulp));
    if (outside) worst_.outer = std::max(worst_.outer, Scalar((distance - law.tethering->distance) / ulp));
  }

  /// Everybody who moves and a surface of a wall.
  void look_at(const WallSurface<Scalar, D>& surface) {
    Scalar& worst = surface.is_inside() ? worst_.outer : worst_.inner;
    for (int i = 0; i < world_.size(); ++i) {
      if (!world_.fixed(i)) worst = std::max(worst, surface.beyond(world_, i, time_));
    }
  }

  const World<Scalar, D>& world_;
  Time<Scalar> time_;
  Scene places_;  ///< the scene with its particles where they are
  std::vector<Vector<Scalar, D>> at_;
  double farthest_ = 0;
  BoundExcess<Scalar> worst_;
};

}  // namespace detail

/// Looks at every pair that can be beyond a limit, and at everybody before every wall, at a time up to which
/// every particle flies straight.
template <typename Scalar, int D>
BoundExcess<Scalar> audit_bounds(const World<Scalar, D>& world, const Time<Scalar>& t) {
  return detail::Audit<Scalar, D>(world, t).excess();
}

}  // namespace tps
