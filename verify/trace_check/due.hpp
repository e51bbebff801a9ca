// When the next event of a pair at a limit may have been computed to be: an interval that holds every answer
// within the error bound of the trace's timing (docs/check.md, "When an event is due").
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/engine/timing.hpp"
#include "reference/equations/square_root.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

/// r, v at one instant, and how far the stored position and the one carried there may be off.
template <typename W>
struct RelativeFlight {
  Vec<W> r, v;
  W blur{0};
  W drift{0};  ///< how far v may be off
};

/// The question of eq. (2): reach the limit L from outside (inner limit) or from inside (outer limit).
template <typename W>
struct LimitAsked {
  bool outer;
  W L;
  bool responded = false;  ///< at the outer limit, and no velocity has changed since
};

/// The squared distance beyond the limit, q(t) = |r + v t|² − L² = a t² + 2 h t + c.
///
/// Of a far pair the terms of q and of h² − a c cancel; q is evaluated where the pair then is, and the
/// discriminant from afar as a L² − |r × v|², so that their errors stay those of L |r|.
template <typename W>
struct Quadratic {
  Vec<W> r, v;
  W L;
  W a, h, c;
  W q_error;  ///< of c, and D's over a: what a time computed as a root misses q = 0 by, but for the others
  W h_error;
  W t_error;        ///< of a time, as a part of it: the roundings of a, of the sum and of the quotient
  W blur_error{0};  ///< part of q_error: of positions that are not known better

  W at(const W& t) const {
    const W distance = length(r + t * v);
    return (distance - L) * (distance + L);
  }
  W discriminant() const {
    if (h * h < a * L * L) return h * h - a * c;
    const Vec<W> moment = cross(r, v);
    return a * L * L - dot(moment, moment);
  }
};

/// docs/check.md derives the bounds of the stable formulas, 16 u L (|r| + L), 6 u |r||v| and 8 u t, and that
/// of the printed ones, 40 u (|r|² + L²).
template <typename W>
Quadratic<W> quadratic_of(const RelativeFlight<W>& flight, const W& L, const W& u, Timing timing,
                          const W& scale) {
  const W rr = dot(flight.r, flight.r);
  const W distance = length(flight.r);
  const W speed = length(flight.v);
  Quadratic<W> q{flight.r,
                 flight.v,
                 L,
                 dot(flight.v, flight.v),
                 dot(flight.r, flight.v),
                 (distance - L) * (distance + L),
                 W(0),
                 W(0),
                 scale * W(8) * u};
  const W rounding = timing == Timing::paper ? W(40) * u * (rr + L * L) : W(16) * u * L * (distance + L);
  q.blur_error = W(2) * (L + flight.blur) * flight.blur;
  q.q_error = scale * (rounding + q.blur_error);
  q.h_error = scale * (W(6) * u * distance * speed + flight.blur * speed + flight.drift * distance);
  return q;
}

/// How far beyond the limit, as squared distance, a pair flies until a time that is computed dt or less after
/// its start: a·q_error of its discriminant is q_error, and while the time is late by t it is 2 L |v| t
/// farther.
template <typename W>
W farthest_beyond(const Quadratic<W>& q, const W& u, const W& scale, const W& dt) {
  return q.q_error + W(2) * q.L * (scale * W(6) * u * length(q.r) + q.t_error * length(q.v) * dt);
}

/// Times from the start of the pair's flight.
template <typename W>
struct Due {
  bool can_be_none;   ///< no event at all is within the bound
  bool must_be_none;  ///< any event would be beyond it
  W earliest, latest;
};

template <typename W>
Due<W> never_due() {
  return {true, true, W(0), W(0)};
}

/// Blocking: the smaller root while approaching.
template <typename W>
Due<W> inner_due(const Quadratic<W>& q) {
  const W zero(0);
  const W widest = q.discriminant() + q.a * q.q_error;
  const W narrowest = q.discriminant() - q.a * q.q_error;
  const bool may_be_inside = q.c <= q.q_error;
  const W closing = std::max(zero, W(-q.h)) + q.h_error;
  Due<W> due;
  due.must_be_none = q.h > q.h_error || (!may_be_inside && widest < zero);
  due.can_be_none = q.h >= -q.h_error || (q.c > -q.q_error && narrowest <= zero);
  due.earliest = may_be_inside ? zero : (q.c - q.q_error) / (closing + square_root(std::max(zero, widest)));
  const W vertex = closing / q.a;
  due.latest = q.c <= -q.q_error ? zero
               : narrowest > zero && q.h < -q.h_error
                   ? std::min(vertex, W((q.c + q.q_error) / (W(-q.h) - q.h_error + square_root(narrowest))))
                   : vertex;
  due.earliest *= W(1) - q.t_error;
  due.latest *= W(1) + q.t_error;
  return due;
}

/// Tethering: the larger root while separating; where rounding left the pair outside, at once or where it
/// turns; where it has just been pulled, only by way of the inside.
template <typename W>
Due<W> outer_due(const Quadratic<W>& q, bool responded) {
  const W zero(0);
  const W early = square_root(std::max(zero, W(q.discriminant() - q.a * q.q_error)));
  const W late = square_root(std::max(zero, W(q.discriminant() + q.a * q.q_error)));
  const auto larger_root = [&](const W& h, const W& root, const W& c) {
    return h > zero && c < zero ? W(-c / (h + root)) : W((root - h) / q.a);
  };
  const bool may_be_outside = q.c >= -q.q_error;
  const bool is_outside = q.c >= q.q_error;
  const bool separates = q.h > q.h_error;
  const W slack = q.h_error / q.a;
  Due<W> due{false, false, zero, zero};
  const W sooner = W(1) - q.t_error, later = W(1) + q.t_error;
  due.earliest = may_be_outside && q.h >= -q.h_error && !responded
                     ? zero
                     : std::max(zero, W(larger_root(q.h, early, q.c + q.q_error) * sooner - slack));
  due.latest = separates && is_outside
                   ? zero
                   : std::max(zero, W(larger_root(q.h, late, q.c - q.q_error) * later + slack));
  if (!responded) return due;
  // It is pulled at once where a position was rounded since (D23), and by semantics 1 never.
  due.can_be_none = may_be_outside && q.h >= -q.h_error;
  if (early == zero)
    due.latest = std::max(due.latest, W(W(2) * std::max(zero, W(-q.h)) / q.a * later + W(2) * slack));
  return due;
}

template <typename W>
Due<W> due(const Quadratic<W>& q, const LimitAsked<W>& asked) {
  if (q.a == W(0)) return never_due<W>();
  return asked.outer ? outer_due(q, asked.responded) : inner_due(q);
}

}  // namespace tps::check
