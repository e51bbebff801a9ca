// A trace as data that a mutation may change: its lines as JSON, and the numbers in them.
#pragma once

#include <cstdint>
#include <string>
#include <valarray>
#include <vector>

#include "reference/scene/scene.hpp"
#include "tests/trace_check/shared_lines.hpp"

namespace tps::mutation {

using Vec = std::valarray<double>;

struct Trace {
  Scene scene;
  std::string scalar;
  SharedLines lines;
  std::size_t torn = 0;  ///< bytes that the file lacks at its end
};

/// The trace that a file holds; text_of is its inverse but for the spelling of decimals in the scene.
Trace trace_of(const std::string& bytes);
std::string text_of(const Trace& trace);

inline bool is_event(const Json& line) {
  return line.contains("k");
}
inline bool is_state(const Json& line) {
  return line.contains("state");
}
inline bool is_end(const Json& line) {
  return line.contains("end");
}
inline bool is_collision(const Json& line) {
  if (!is_event(line)) return false;
  const std::string kind = line.at("kind");
  return kind == "rebound" || kind == "retract" || kind == "revolve";
}
inline bool is_pull(const Json& line) {
  return is_collision(line) && line.at("kind") != "rebound";
}
inline bool is_load(const Json& line) {
  return line.contains("members");
}

/// The lines of the events, in order.
std::vector<std::size_t> event_lines(const Trace& trace);

/// Numbers events and states again, and what follows from that: dt, the times, counts and marks of the
/// states, the end's count. Changes nothing in a trace that is right.
void settle(Trace& trace);

/// The nearest double.
double number(const Json& hex);
Vec numbers(const Json& hexes);
double dot(const Vec& a, const Vec& b);
double length(const Vec& v);

/// The spelling of a number in the scalar of the trace, rounded once. REQUIRES float or double.
std::string spelt(const Trace& trace, double x);
Json spelt(const Trace& trace, const Vec& v);
/// Distance from 1 to the next number of the trace's scalar.
double epsilon(const Trace& trace);
/// The number that is `ulps` steps of the scalar away from zero.
std::string stepped(const Trace& trace, const Json& hex, int ulps);

/// b − a of two exact times, rounded once.
double elapsed(const Json& a, const Json& b);
/// Time since the start of the run.
double since_start(const Trace& trace, const Json& t);
/// The exact time on the scene's clock so long after the start. `since` is rounded to the scalar.
std::string clock_time(const Trace& trace, double since);

/// "3" for 3: how an event names a particle.
inline std::string key(int id) {
  return std::to_string(id);
}

}  // namespace tps::mutation
