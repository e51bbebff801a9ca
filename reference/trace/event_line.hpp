// The lines of a trace, docs/trace.md.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "reference/engine/drag_clock.hpp"
#include "reference/engine/record.hpp"
#include "reference/scene/scene.hpp"
#include "reference/text/append_hex.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/pen.hpp"

namespace tps {

/// Writes the exact time on the scene's clock, start_time + hi + lo, in as many digits as that takes.
template <typename Scalar>
void put_time(Pen& pen, double start_time, const Time<Scalar>& t) {
  if (start_time == 0 && t.lo == Scalar(0)) return pen.put_hex(t.hi);
  if (start_time == 0) return pen.put_hex_sum(t.hi, t.lo);
  const std::array<HexDigits, 3> terms = {hex_digits(start_time), hex_digits(t.hi), hex_digits(t.lo)};
  pen.put_text(join_hex(exact_sum(terms)));
}

template <typename Scalar>
std::string exact_time(double start_time, const Time<Scalar>& t) {
  std::string text;
  {
    Pen pen(text);
    put_time(pen, start_time, t);
  }
  return text;
}

/// The last moment of a duration on the clock of a run: under drag s(T) rounded down to the scalar, T being
/// at most the last time that can be printed.
template <typename Scalar>
Time<Scalar> clock_until(const Scene& scene, double duration) {
  if (!scene.drag) return {Scalar(duration), Scalar(0)};
  const double s = drag_clock_until(scene.drag->gamma, std::min(duration, last_drag_time(scene.start_time)));
  const auto held = static_cast<Scalar>(s);
  const bool is_above = static_cast<double>(held) > s;  // of float
  return {is_above ? next_number(held, Rounding::down) : held, Scalar(0)};
}

/// Where the clock of a run stands, on the scene's clock: exactly, under drag the nearest double.
template <typename Scalar>
std::string time_of(const Scene& scene, const Time<Scalar>& now) {
  if (!scene.drag) return exact_time(scene.start_time, now);
  return to_hex(drag_time(scene.drag->gamma, whole(now), scene.start_time));
}
/// The clock itself, where it is not the scene's: `,"s":"…"`.
template <typename Scalar>
std::string clock_member(const Scene& scene, const Time<Scalar>& now) {
  return scene.drag ? ",\"s\":\"" + exact_time(0, now) + "\"" : std::string();
}

namespace detail {

template <typename Scalar, int D>
void put_vector(Pen& pen, const Vector<Scalar, D>& v) {
  for (int k = 0; k < D; ++k) {
    if (k == 0) {
      pen.put("[\"");
    } else {
      pen.put("\",\"");
    }
    pen.put_hex(Scalar(v[k]));
  }
  pen.put("\"]");
}

template <typename Scalar>
void put_spin(Pen& pen, const std::vector<Scalar>& spin) {
  std::string_view separator = ",\"spin\":[\"";
  for (const Scalar& x : spin) {
    pen.put_text(separator);
    pen.put_hex(x);
    separator = "\",\"";
  }
  pen.put("\"]");
}

/// Where the positions of the first two particles of an event stand in its line: they are the same before and
/// after.
struct PlacesOfPositions {
  struct Place {
    std::size_t begin = 0, bytes = 0;
  };
  std::array<Place, 2> of;
};

/// {"0":{"position":[…],"velocity":[…]},…}, velocities before or after the event.
template <typename Scalar, int D>
void put_states(Pen& pen, const Scene& scene, const Record<Scalar, D>& record, bool after_event,
                PlacesOfPositions& places) {
  char separator = '{';
  for (std::size_t n = 0; n < record.involved.size(); ++n) {
    const ParticleChange<Scalar, D>& change = record.involved[n];
    pen.put(separator);
    pen.put('"');
    pen.put_natural(scene.particles[static_cast<std::size_t>(change.particle)].id);
    pen.put("\":{\"position\":");
    if (after_event && n < places.of.size()) {
      pen.put_again(places.of[n].begin, places.of[n].bytes);
    } else {
      const std::size_t begin = pen.length();
      put_vector<Scalar, D>(pen, change.position);
      if (n < places.of.size()) places.of[n] = {begin, pen.length() - begin};
    }
    pen.put(",\"velocity\":");
    put_vector<Scalar, D>(pen, after_event ? change.velocity_after : change.velocity_before);
    if (record.addition != nullptr) {
      for (const SpinChange<Scalar>& spin : record.addition->spins) {
        if (spin.particle == change.particle) put_spin(pen, after_event ? spin.after : spin.before);
      }
    }
    pen.put('}');
    separator = ',';
  }
  pen.put('}');
}

template <std::size_t N>
void put_member(Pen& pen, const char (&key)[N], std::integral auto number) {
  pen.put(key);
  pen.put_natural(number);
}

template <typename Scalar, int D, std::size_t N>
void put_member(Pen& pen, const char (&key)[N], const std::optional<Vector<Scalar, D>>& v) {
  if (!v) return;
  pen.put(key);
  put_vector<Scalar, D>(pen, *v);
}

template <typename Scalar, int D>
void put_times(Pen& pen, const Scene& scene, const Record<Scalar, D>& record) {
  pen.put(",\"t\":\"");
  if (scene.drag) {
    pen.put_text(time_of(scene, record.t));
    pen.put('"');
    pen.put_text(clock_member(scene, record.t));
    pen.put(",\"ds\":\"");
  } else {
    put_time(pen, scene.start_time, record.t);
    pen.put("\",\"dt\":\"");
  }
  pen.put_hex(record.dt);
  pen.put('"');
}

inline void put_members(Pen& pen, const Scene& scene, const std::vector<int>& members) {
  if (members.empty()) return;
  pen.put(",\"members\":");
  char separator = '[';
  for (const int m : members) {
    pen.put(separator);
    pen.put_natural(scene.particles[static_cast<std::size_t>(m)].id);
    separator = ',';
  }
  pen.put(']');
}

template <typename Scalar>
void put_own(Pen& pen, const OwnField<Scalar>& field) {
  pen.put(",\"");
  pen.put_text(field.key);
  pen.put("\":");
  if (const auto* whole = std::get_if<std::int64_t>(&field.value)) {
    pen.put_natural(*whole);
  } else if (const auto* word = std::get_if<std::string_view>(&field.value)) {
    pen.put('"');
    pen.put_text(*word);
    pen.put('"');
  } else {
    const auto& numbers = std::get<std::vector<Scalar>>(field.value);
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      pen.put_text(n == 0 ? "[\"" : "\",\"");
      pen.put_hex(numbers[n]);
    }
    pen.put_text(numbers.empty() ? "[]" : "\"]");
  }
}

}  // namespace detail

/// Appends one event as a line of JSON, with its end.
template <typename Scalar, int D>
void append_event(std::string& line, const Scene& scene, const Record<Scalar, D>& record) {
  const auto id = [&](int i) { return scene.particles[static_cast<std::size_t>(i)].id; };
  const Addition<Scalar, D>* const added = record.addition;
  Pen pen(line);
  detail::put_member(pen, "{\"k\":", record.k);
  detail::put_times(pen, scene, record);
  pen.put(",\"kind\":\"");
  pen.put_text(record.kind);
  pen.put('"');
  if (added != nullptr) {
    if (added->phase) detail::put_member(pen, ",\"phase\":", *added->phase);
    if (added->wall) detail::put_member(pen, ",\"wall\":", *added->wall);
    if (added->face) detail::put_member(pen, ",\"face\":", *added->face);
  }
  if (record.i >= 0) detail::put_member(pen, ",\"i\":", id(record.i));
  if (record.j >= 0 && record.j != record.i) detail::put_member(pen, ",\"j\":", id(record.j));
  if (!record.involved.empty()) {
    detail::PlacesOfPositions places;
    pen.put(",\"pre\":");
    detail::put_states<Scalar, D>(pen, scene, record, false, places);
    pen.put(",\"post\":");
    detail::put_states<Scalar, D>(pen, scene, record, true, places);
  }
  detail::put_member<Scalar, D>(pen, ",\"dp\":", record.dp);
  if (added != nullptr) {
    detail::put_member<Scalar, D>(pen, ",\"dv\":", added->dv);
    detail::put_member<Scalar, D>(pen, ",\"dp_stored\":", added->dp_stored);
    for (const OwnField<Scalar>& field : added->own) detail::put_own(pen, field);
    if (added->sticks) pen.put_text(*added->sticks ? ",\"contact\":\"sticks\"" : ",\"contact\":\"slides\"");
  }
  if (record.tether == TetherChange::formed) pen.put(",\"tether\":\"formed\"");
  if (record.tether == TetherChange::broken) pen.put(",\"tether\":\"broken\"");
  if (record.draw) {
    pen.put(",\"draw\":\"");
    pen.put_hex(*record.draw);
    pen.put('"');
  }
  if (added != nullptr) detail::put_members(pen, scene, added->members);
  pen.put("}\n");
}

}  // namespace tps
