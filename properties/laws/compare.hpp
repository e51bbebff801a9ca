// How laws compare, and what they say where the comparison fails. Heavy header: only sources of laws include
// it.
#pragma once

#include <string>

#include "properties/interview.hpp"
#include "properties/outcome.hpp"

namespace tps::properties {

inline std::string text(const Wide& x) {
  return x.str(6);
}
inline std::string text(const WideVector& a) {
  return "(" + a.x.str(17) + ", " + a.y.str(17) + ", " + a.z.str(17) + ")";
}
inline std::string text(const Time& time) {
  return time.verdict + (time.t ? " at " + time.t->str(17) : " without a time");
}
inline std::string text(const std::string& word) {
  return word;
}

/// REQUIRES bound ≥ 0. NaN and infinity are not at most anything.
inline Outcome at_most(const std::string& what, const Wide& found, const Wide& bound) {
  if (found <= bound) return {};
  return broken(what + " is " + text(found) + "; at most " + text(bound));
}

template <typename T>
Outcome same(const std::string& what, const T& one, const T& other) {
  if (one == other) return {};
  return broken(what + ": " + text(one) + ", but " + text(other));
}

/// Bitwise, or else to `rounding`: the errors that the laws to rounding leave both answers. Real arithmetic
/// gives one answer to both questions, so each is off by at most its own error.
inline Outcome same_to(const std::string& what, const WideVector& one, const WideVector& other,
                       const Wide& rounding) {
  const Outcome bitwise = same(what, one, other);
  if (bitwise.kind == Outcome::Kind::holds) return bitwise;
  const Wide apart = norm(one - other);
  if (apart <= rounding)
    return to_rounding(bitwise.why + ": " + text(apart) + " apart, which rounding may do up to " +
                       text(rounding));
  return broken(bitwise.why + ": " + text(apart) + " apart; rounding explains at most " + text(rounding));
}

inline WideVector opposite(const WideVector& a) {
  return {-a.x, -a.y, -a.z};
}

/// A pair with the names exchanged.
inline PairState swapped(const PairState& p) {
  return {p.u_B, p.u_A, p.v_B, p.v_A};
}
inline Masses swapped(const Masses& m) {
  return {m.B, m.A};
}

inline Vec3 scaled(const Vec3& x, int power) {
  return {std::ldexp(x[0], power), std::ldexp(x[1], power), std::ldexp(x[2], power)};
}
/// Lengths times 2^length, velocities times 2^speed.
inline PairState scaled(const PairState& p, int length, int speed) {
  return {scaled(p.u_A, length), scaled(p.u_B, length), scaled(p.v_A, speed), scaled(p.v_B, speed)};
}

/// A pair as responses see it.
struct Encounter {
  explicit Encounter(const PairState& p)
      : r(wide(p.u_B) - wide(p.u_A)), v(wide(p.v_B) - wide(p.v_A)), distance(norm(r)), speed(norm(v)) {
    if (distance == 0) throw Unanswered{outside("the positions are one point: û is not defined")};
    n = r / distance;
    v_n = dot(v, n);
    w = v - v_n * n;
    tangential = norm(w);
  }

  WideVector r, v;
  Wide distance, speed;
  WideVector n;  ///< û
  Wide v_n;
  WideVector w;     ///< v_ŵ
  Wide tangential;  ///< |v_ŵ|
};

}  // namespace tps::properties
