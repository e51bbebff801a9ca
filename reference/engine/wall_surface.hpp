// One surface of a wall, as a particle meets it: when, along which axis, and whether it leaves already.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/engine/response.hpp"
#include "reference/engine/world.hpp"
#include "reference/equations/directed_rounding.hpp"
#include "reference/equations/first_touch.hpp"
#include "reference/scene/surfaces.hpp"

namespace tps {

/// In the engine's scalar. Its place at t is p + V t, three roundings a coordinate as of a particle in
/// flight.
template <typename Scalar, int D>
class WallSurface {
 public:
  using Vec = Vector<Scalar, D>;

  WallSurface(const Surface& surface, const Scene& scene)
      : surface_(surface),
        point_(lifted<Scalar, D>(surface.point)),
        normal_(lifted<Scalar, D>(surface.normal)),
        velocity_(lifted<Scalar, D>(surface.velocity)),
        c_rebound_(Scalar(surface.c_rebound)) {
    if (surface.region) {
      low_ = lifted<Scalar, D>(surface.region->low);
      high_ = lifted<Scalar, D>(surface.region->high);
    }
    for (const Species& species : scene.species)
      distances_.push_back(Scalar(touching_distance(surface, species.radius)));
  }

  const Surface& surface() const { return surface_; }
  const Vec& velocity() const { return velocity_; }
  const Scalar& c_rebound() const { return c_rebound_; }
  bool is_plane() const { return surface_.kind == Surface::Kind::plane; }
  bool is_inside() const { return surface_.kind == Surface::Kind::inside; }
  /// L of a particle.
  const Scalar& distance(const World<Scalar, D>& world, int i) const {
    return distances_[world.index(world.species(i))];
  }
  std::string with(const World<Scalar, D>& world, int i) const {
    return particle_name(world.scene, i) + " and " + surface_name(surface_);
  }

  Vec place(const Time<Scalar>& t) const { return moved(point_, t); }

  /// The positions whose difference is the axis now, from the particle A to the wall B: along a plane's
  /// normal wherever on it the particle is.
  std::pair<Vec, Vec> axis(const World<Scalar, D>& world, int i) const {
    if (is_plane()) return {normal_, Vec(Vec::Zero())};
    return {measured(world.position(i, world.now)), measured(place(world.now))};
  }

  /// Whether a particle moves away from the limit, exactly on the stored numbers: then there is nothing to
  /// answer. From inside of a sphere, across the axis is no leaving.
  bool leaves(const World<Scalar, D>& world, int i) const {
    const auto [u_A, u_B] = axis(world, i);
    const int sign = normal_sign<Scalar, D>(u_A, u_B, world.velocity(i), velocity_);
    return is_inside() ? sign < 0 : sign >= 0;
  }

  /// When a particle meets the surface next. Throws OutOfRange.
  std::optional<Time<Scalar>> next(const World<Scalar, D>& world, int i) const {
    const ParticleState<Scalar, D>& p = world.particles[world.index(i)];
    if (!is_finite<Scalar, D>(Vec(p.position - place(p.clock))))
      throw OutOfRange("the distance of " + with(world, i));
    const std::optional<Scalar> dt = is_plane() ? to_plane(world, i) : to_sphere(world, i);
    if (!dt || (surface_.region && !is_nearest(p, distance(world, i)))) return std::nullopt;
    if (!(*dt >= Scalar(0))) throw OutOfRange("the time of " + with(world, i));
    return after(p.clock, *dt);
  }

  /// What next() rounds. REQUIRES certified timing.
  Moment moment(const World<Scalar, D>& world, int i) const {
    const Time<Scalar>& clock = world.particles[world.index(i)].clock;
    if (is_plane()) return world.timing.moment(clock, query(world, i));
    return world.timing.moment(view(world, i), question(world, i));
  }

  /// How far a particle is beyond the limit at a time of its flight, in ulps of its largest coordinate.
  Scalar beyond(const World<Scalar, D>& world, int i, const Time<Scalar>& t) const {
    const Vec u = world.position(i, t);
    const Vec at = place(t);
    if (surface_.region && !faces(u, t)) return Scalar(0);
    const Scalar distance_now =
        is_plane() ? Scalar(normal_.dot(u - at)) : norm<Scalar, D>(measured(u) - measured(at));
    const Scalar inside = (distance(world, i) - distance_now) / coordinate_ulp<Scalar, D>(u, at);
    return is_inside() ? Scalar(-inside) : inside;
  }

  /// Whether rounding alone can have made v_n (response.hpp): the axis of a plane is stored, that of a sphere
  /// turns with the positions.
  bool below_rounding(const World<Scalar, D>& world, int i, const CollisionFrame<Scalar, D>& frame) const {
    using std::abs;
    const Scalar u = std::numeric_limits<Scalar>::epsilon() / Scalar(2);
    const auto [u_A, u_B] = axis(world, i);
    const Scalar reach = u_A.cwiseAbs().maxCoeff() + u_B.cwiseAbs().maxCoeff();
    const Scalar turn =
        Scalar(2) * u +
        (is_plane() ? Scalar(0) : Scalar(Scalar(2 * D) * u * reach / norm<Scalar, D>(u_B - u_A)));
    const Scalar speeds = norm<Scalar, D>(world.velocity(i)) + norm<Scalar, D>(velocity_);
    return abs(frame.v_n) <= Scalar(2) * u * speeds + turn * norm<Scalar, D>(frame.v_AB);
  }

 private:
  using Side = BoxRegion::Side;

  Vec moved(const Vec& x, const Time<Scalar>& t) const {
    if (velocity_ == Vec::Zero() || t == Time<Scalar>{}) return x;
    return x + velocity_ * elapsed(Time<Scalar>{}, t);
  }

  /// The components along which the distance from a part of a box is measured; else all.
  Vec measured(Vec x) const {
    for (int k = 0; surface_.region && k < D; ++k) {
      if (!surface_.region->measures(static_cast<std::size_t>(k))) x[k] = Scalar(0);
    }
    return x;
  }

  /// Whether a particle touches this part of the box, and where it is the nearest, exactly on the stored
  /// numbers: on the border between two parts both are. REQUIRES that it approaches.
  bool is_nearest(const ParticleState<Scalar, D>& p, const Scalar& L) const {
    const BoxRegion& region = *surface_.region;
    const FirstTouch<Scalar, D> touch(place(p.clock), p.position, velocity_, p.velocity, L,
                                      {region.measures(0), region.measures(1), region.measures(2)});
    if (!is_plane() && !touch.happens()) return false;
    const Vec low = moved(low_, p.clock), high = moved(high_, p.clock);
    for (int k = 0; k < D; ++k) {
      const Side side = region.sides[static_cast<std::size_t>(k)];
      if (side == Side::below ? touch.side(k, low[k]) > 0
                              : side == Side::between && touch.side(k, low[k]) < 0)
        return false;
      if (side == Side::above ? touch.side(k, high[k]) < 0
                              : side == Side::between && touch.side(k, high[k]) > 0)
        return false;
    }
    return true;
  }

  /// Whether a place is before this part of the box, or behind a face of it inside of the box.
  bool faces(const Vec& u, const Time<Scalar>& t) const {
    const Vec low = moved(low_, t), high = moved(high_, t);
    for (int k = 0; k < D; ++k) {
      const Side side = surface_.region->sides[static_cast<std::size_t>(k)];
      const Scalar& most = side == Side::below && !is_plane() ? low[k] : high[k];
      const Scalar& least = side == Side::above && !is_plane() ? high[k] : low[k];
      if ((side != Side::above && u[k] > most) || (side != Side::below && u[k] < least)) return false;
    }
    return true;
  }

  PairView<Scalar, D> view(const World<Scalar, D>& world, int i) const {
    const ParticleState<Scalar, D>& p = world.particles[world.index(i)];
    return {i,
            i,
            p.clock,
            measured(p.position),
            measured(place(p.clock)),
            measured(p.velocity),
            measured(velocity_)};
  }

  TimingQuery query(const World<Scalar, D>& world, int i) const {
    using Lift = PairTiming<Scalar, D>;
    const ParticleState<Scalar, D>& p = world.particles[world.index(i)];
    return {TimingKind::plane,       Lift::lifted(place(p.clock)), Lift::lifted(p.position),
            Lift::lifted(velocity_), Lift::lifted(p.velocity),     static_cast<double>(distance(world, i)),
            Lift::lifted(normal_)};
  }

  /// t = (n·r − L)/(−n·v), at once where the particle is at the plane or behind it.
  std::optional<Scalar> to_plane(const World<Scalar, D>& world, int i) const {
    const ParticleState<Scalar, D>& p = world.particles[world.index(i)];
    if (normal_sign<Scalar, D>(normal_, Vec(Vec::Zero()), p.velocity, velocity_) >= 0) return std::nullopt;
    if (world.timing.certified()) return world.timing.certified_time(query(world, i));
    const Scalar gap = normal_.dot(p.position - place(p.clock)) - distance(world, i);
    if (gap <= Scalar(0)) return Scalar(0);
    const Scalar towards = -normal_.dot(p.velocity - velocity_);
    return towards > Scalar(0) ? Scalar(gap / towards) : std::numeric_limits<Scalar>::infinity();
  }

  /// From inside, one that exactly moves inwards has the wall ahead on the far side only: as a pair that was
  /// pulled (pair_timing.hpp).
  LimitQuestion<Scalar> question(const World<Scalar, D>& world, int i) const {
    const PairView<Scalar, D> seen = view(world, i);
    const bool inwards = normal_sign<Scalar, D>(seen.u_i, seen.u_j, seen.v_i, seen.v_j) < 0;
    return {is_inside() ? TimingKind::tether : TimingKind::block, distance(world, i), is_inside() && inwards};
  }

  /// Eq. (2). From outside the exact sign of the approach goes before the rounded one.
  std::optional<Scalar> to_sphere(const World<Scalar, D>& world, int i) const {
    const PairView<Scalar, D> seen = view(world, i);
    const int sign = normal_sign<Scalar, D>(seen.u_i, seen.u_j, seen.v_i, seen.v_j);
    if (!is_inside() && sign >= 0) return std::nullopt;
    const std::optional<Scalar> dt = world.timing.next(seen, question(world, i));
    const bool touches = !is_inside() && !world.timing.certified() &&
                         norm<Scalar, D>(seen.u_j - seen.u_i) <= distance(world, i);
    return dt || !touches ? dt : std::optional<Scalar>(Scalar(0));
  }

  Surface surface_;
  Vec point_, normal_, velocity_;
  Vec low_ = Vec::Zero(), high_ = Vec::Zero();  ///< the ends of a box, of its outside
  Scalar c_rebound_;
  std::vector<Scalar> distances_;  ///< by species
};

}  // namespace tps
