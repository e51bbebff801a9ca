// The lines of a trace, docs/trace.md.
#pragma once

#include <string>
#include <string_view>

#include "reference/engine/drag_clock.hpp"
#include "reference/engine/record.hpp"
#include "reference/scene/scene.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps {

/// The exact time on the scene's clock, start_time + hi + lo, in as many digits as that takes.
template <typename Scalar>
std::string exact_time(double start_time, const Time<Scalar>& t) {
  if (start_time == 0 && t.lo == Scalar(0)) return to_hex(t.hi);
  const std::array<HexDigits, 3> terms = {hex_digits(start_time), hex_digits(t.hi), hex_digits(t.lo)};
  return join_hex(exact_sum(terms));
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
  for (int k = 0; k < D; ++k) line.append(k == 0 ? "[\"" : "\",\"").append(to_hex(Scalar(v[k])));
  line.append("\"]");
}

template <typename Scalar>
void append_spin(std::string& line, const std::vector<Scalar>& spin) {
  const char* separator = ",\"spin\":[\"";
  for (const Scalar& x : spin) {
    line.append(separator).append(to_hex(x));
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
    line.append("\"").append(std::to_string(scene.particles[static_cast<std::size_t>(change.particle)].id));
    line.append("\":{\"position\":");
    append_vector<Scalar, D>(line, change.position);
    line.append(",\"velocity\":");
    append_vector<Scalar, D>(line, after_event ? change.velocity_after : change.velocity_before);
    for (const SpinChange<Scalar>& spin : record.spins) {
      if (spin.particle == change.particle) append_spin(line, after_event ? spin.after : spin.before);
    }
    line.push_back('}');
    separator = ',';
  }
  line.push_back('}');
}

}  // namespace detail

/// One event as a line of JSON, without its end.
template <typename Scalar, int D>
std::string event_line(const Scene& scene, const Record<Scalar, D>& record) {
  const auto id = [&](int i) { return std::to_string(scene.particles[static_cast<std::size_t>(i)].id); };
  std::string line;
  line.append("{\"k\":").append(std::to_string(record.k));
  line.append(",\"t\":\"")
      .append(time_of(scene, record.t))
      .append("\"")
      .append(clock_member(scene, record.t));
  line.append(scene.drag ? ",\"ds\":\"" : ",\"dt\":\"").append(to_hex(record.dt));
  line.append("\",\"kind\":\"").append(record.kind).append("\"");
  if (record.detail) line.append(",\"phase\":").append(std::to_string(*record.detail));
  if (record.wall) line.append(",\"wall\":").append(std::to_string(*record.wall));
  if (record.face) line.append(",\"face\":").append(std::to_string(*record.face));
  if (record.i >= 0) line.append(",\"i\":").append(id(record.i));
  if (record.j >= 0 && record.j != record.i) line.append(",\"j\":").append(id(record.j));
  if (!record.involved.empty()) {
    line.append(",\"pre\":");
    detail::append_states<Scalar, D>(line, scene, record, false);
    line.append(",\"post\":");
    detail::append_states<Scalar, D>(line, scene, record, true);
  }
  if (record.dp) {
    line.append(",\"dp\":");
    detail::append_vector<Scalar, D>(line, *record.dp);
  }
  if (record.dv) {
    line.append(",\"dv\":");
    detail::append_vector<Scalar, D>(line, *record.dv);
  }
  if (record.dp_stored) {
    line.append(",\"dp_stored\":");
    detail::append_vector<Scalar, D>(line, *record.dp_stored);
  }
  if (record.sticks) line.append(*record.sticks ? ",\"contact\":\"sticks\"" : ",\"contact\":\"slides\"");
  if (record.tether != TetherChange::none) {
    line.append(",\"tether\":\"")
        .append(record.tether == TetherChange::formed ? "formed" : "broken")
        .append("\"");
  }
  if (record.draw) line.append(",\"draw\":\"").append(to_hex(*record.draw)).append("\"");
  if (!record.members.empty()) {
    char separator = '[';
    line.append(",\"members\":");
    for (const int m : record.members) {
      line.push_back(separator);
      line.append(id(m));
      separator = ',';
    }
    line.push_back(']');
  }
  line.push_back('}');
  return line;
}

}  // namespace tps
