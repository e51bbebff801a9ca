#include "properties/generators/pairs.hpp"

#include <array>
#include <cmath>
#include <ostream>

#include "properties/generators/numbers.hpp"
#include "reference/equations/collision_frame.hpp"

namespace tps::properties {
namespace {

constexpr std::array<const char*, 6> aim_names{"general", "graze", "touch", "taut", "head-on", "static"};

/// Puts a relative state (r, v) into the world at a place and velocity of A.
template <int D>
Pair<D> placed(Aim aim, const Vector<double, D>& r, const Vector<double, D>& v, double L,
               const Vector<double, D>& u_A, const Vector<double, D>& v_A) {
  return {aim, u_A, u_A + r, v_A, v_A + v, L};
}

/// A unit vector perpendicular to n, by projection of an axis.
template <int D>
Vector<double, D> across(const Vector<double, D>& n) {
  Vector<double, D> axis = Vector<double, D>::Unit(std::abs(n[0]) < 0.7 ? 0 : 1);
  axis -= axis.dot(n) * n;
  return axis.normalized();
}

template <int D>
Pair<D> aimed(Aim aim, const Vector<double, D>& direction, double L, double speed, double distance,
              const Vector<double, D>& u_A, const Vector<double, D>& v_A) {
  const Vector<double, D> n = direction.norm() == 0 ? Vector<double, D>(Vector<double, D>::Unit(0))
                                                    : Vector<double, D>(direction.normalized());
  const Vector<double, D> w = across<D>(n);
  const Vector<double, D> far = -(L + distance) * n;
  switch (aim) {
    case Aim::graze:
      return placed<D>(aim, Vector<double, D>(far + L * w), speed * n, L, u_A, v_A);
    case Aim::touch:
      return placed<D>(aim, Vector<double, D>(-L * n), Vector<double, D>(speed * (n + w)), L, u_A, v_A);
    case Aim::taut:
      return placed<D>(aim, Vector<double, D>(L * n), speed * w, L, u_A, v_A);
    case Aim::head_on:
      return placed<D>(aim, far, speed * n, L, u_A, v_A);
    default:
      return placed<D>(aim, far, Vector<double, D>::Zero(), L, u_A, v_A);
  }
}

}  // namespace

template <int D>
std::ostream& operator<<(std::ostream& out, const Pair<D>& p) {
  out.precision(17);
  return out << aim_names[static_cast<std::size_t>(p.aim)] << ": u_A = " << p.u_A.transpose()
             << ", u_B = " << p.u_B.transpose() << ", v_A = " << p.v_A.transpose()
             << ", v_B = " << p.v_B.transpose() << ", L = " << p.L;
}

template <int D>
rc::Gen<Vector<double, D>> vector() {
  return rc::gen::exec([] {
    Vector<double, D> x;
    for (int k = 0; k < D; ++k) x[k] = *number();
    return x;
  });
}

template <int D>
rc::Gen<Pair<D>> pair() {
  return rc::gen::exec([] {
    const Aim aim =
        *rc::gen::element(Aim::general, Aim::graze, Aim::touch, Aim::taut, Aim::head_on, Aim::static_pair);
    const Vector<double, D> u_A = *vector<D>(), v_A = *vector<D>();
    const double L = std::abs(*number()) + std::ldexp(1.0, -60);
    if (aim == Aim::general) return Pair<D>{aim, u_A, *vector<D>(), v_A, *vector<D>(), L};
    return aimed<D>(aim, *vector<D>(), L, std::abs(*number()), std::abs(*number()), u_A, v_A);
  });
}

template <int D>
rc::Gen<Pair<D>> turning_pair() {
  return rc::gen::suchThat(pair<D>(), [](const Pair<D>& p) {
    if (p.u_A == p.u_B || p.v_A == p.v_B) return false;
    const CollisionFrame<double, D> f = collision_frame<double, D>(p.u_A, p.u_B, p.v_A, p.v_B);
    return f.v_w.norm() >= 1e-3 * f.v_AB.norm();
  });
}

template std::ostream& operator<<(std::ostream&, const Pair<2>&);
template std::ostream& operator<<(std::ostream&, const Pair<3>&);
template rc::Gen<Vector<double, 2>> vector<2>();
template rc::Gen<Vector<double, 3>> vector<3>();
template rc::Gen<Pair<2>> pair<2>();
template rc::Gen<Pair<3>> pair<3>();
template rc::Gen<Pair<2>> turning_pair<2>();
template rc::Gen<Pair<3>> turning_pair<3>();

}  // namespace tps::properties
