// The lines of a trace, docs/trace.md.
#pragma once

#include <string>
#include <string_view>

#include "reference/engine/drag_clock.hpp"
#include "reference/engine/record.hpp"
#include "reference/scene/scene.hpp"
#include "reference/text/append_hex.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps {

/// Appends the exact time on the scene's clock, start_time + hi + lo, in as many digits as that takes.
template <typename Scalar>
void append_time(std::string& line, double start_time, const Time<Scalar>& t) {
  if (start_time == 0 && t.lo == Scalar(0)) return append_hex(line, t.hi);
  if (start_time == 0) return append_hex_sum(line, t.hi, t.lo);
  const std::array<HexDigits, 3> terms = {hex_digits(start_time), hex_digits(t.hi), hex_digits(t.lo)};
  line.append(join_hex(exact_sum(terms)));
}

template <typename Scalar>
std::string exact_time(double start_time, const Time<Scalar>& t) {
  std::string text;
  append_time(text, start_time, t);
  return text;
}

/// The last moment of a duration on the clock of a run: under drag s(T) rounded down to the scalar.
template <typename Scalar>
Time<Scalar> clock_until(const Scene& scene, double duration) {
  if (!scene.drag) return {Scalar(duration), Scalar(0)};
  const double s = drag_clock_until(scene.drag->gamma, duration);
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
void append_vector(std::string& line, const Vector<Scalar, D>& v) {
  for (int k = 0; k < D; ++k) {
    line.append(k == 0 ? "[\"" : "\",\"");
    append_hex(line, v[k]);
  }
  line.append("\"]");
}

template <typename Scalar>
void append_spin(std::string& line, const std::vector<Scalar>& spin) {
  const char* separator = ",\"spin\":[\"";
  for (const Scalar& x : spin) {
    line.append(separator);
    append_hex(line, x);
    separator = "\",\"";
  }
  line.append("\"]");
}

/// {"0":{"position":[…],"velocity":[…]},…}, velocities before or after the event.
template <typename Scalar, int D>
void append_states(std::string& line, const Scene& scene, const Record<Scalar, D>& record, bool after_event) {
  char separator = '{';
  for (const ParticleChange<Scalar, D>& change : record.involved) {
    line.push_back(separator);
    line.push_back('"');
    append_decimal(line, scene.particles[static_cast<std::size_t>(change.particle)].id);
    line.append("\":{\"position\":");
    append_vector<Scalar, D>(line, change.position);
    line.append(",\"velocity\":");
    append_vector<Scalar, D>(line, after_event ? change.velocity_after : change.velocity_before);
    if (record.addition != nullptr) {
      for (const SpinChange<Scalar>& spin : record.addition->spins) {
        if (spin.particle == change.particle) append_spin(line, after_event ? spin.after : spin.before);
      }
    }
    line.push_back('}');
    separator = ',';
  }
  line.push_back('}');
}

/// ,"key":number
inline void append_member(std::string& line, const char* key, std::integral auto number) {
  line.append(",\"").append(key).append("\":");
  append_decimal(line, number);
}

template <typename Scalar, int D>
void append_member(std::string& line, const char* key, const std::optional<Vector<Scalar, D>>& v) {
  if (!v) return;
  line.append(",\"").append(key).append("\":");
  append_vector<Scalar, D>(line, *v);
}

}  // namespace detail

/// Appends one event as a line of JSON, with its end.
template <typename Scalar, int D>
void append_event(std::string& line, const Scene& scene, const Record<Scalar, D>& record) {
  const auto id = [&](int i) { return scene.particles[static_cast<std::size_t>(i)].id; };
  line.append("{\"k\":");
  append_decimal(line, record.k);
  line.append(",\"t\":\"");
  if (scene.drag) {
    line.append(time_of(scene, record.t)).append("\"").append(clock_member(scene, record.t));
    line.append(",\"ds\":\"");
  } else {
    append_time(line, scene.start_time, record.t);
    line.append("\",\"dt\":\"");
  }
  append_hex(line, record.dt);
  line.append("\",\"kind\":\"").append(record.kind).append("\"");
  if (const Addition<Scalar, D>* added = record.addition) {
    if (added->phase) detail::append_member(line, "phase", *added->phase);
    if (added->wall) detail::append_member(line, "wall", *added->wall);
    if (added->face) detail::append_member(line, "face", *added->face);
  }
  if (record.i >= 0) detail::append_member(line, "i", id(record.i));
  if (record.j >= 0 && record.j != record.i) detail::append_member(line, "j", id(record.j));
  if (!record.involved.empty()) {
    line.append(",\"pre\":");
    detail::append_states<Scalar, D>(line, scene, record, false);
    line.append(",\"post\":");
    detail::append_states<Scalar, D>(line, scene, record, true);
  }
  detail::append_member<Scalar, D>(line, "dp", record.dp);
  if (const Addition<Scalar, D>* added = record.addition) {
    detail::append_member<Scalar, D>(line, "dv", added->dv);
    detail::append_member<Scalar, D>(line, "dp_stored", added->dp_stored);
    if (added->sticks) line.append(*added->sticks ? ",\"contact\":\"sticks\"" : ",\"contact\":\"slides\"");
  }
  if (record.tether != TetherChange::none) {
    line.append(record.tether == TetherChange::formed ? ",\"tether\":\"formed\"" : ",\"tether\":\"broken\"");
  }
  if (record.draw) {
    line.append(",\"draw\":\"");
    append_hex(line, *record.draw);
    line.push_back('"');
  }
  if (record.addition != nullptr && !record.addition->members.empty()) {
    char separator = '[';
    line.append(",\"members\":");
    for (const int m : record.addition->members) {
      line.push_back(separator);
      append_decimal(line, id(m));
      separator = ',';
    }
    line.push_back(']');
  }
  line.append("}\n");
}

}  // namespace tps
