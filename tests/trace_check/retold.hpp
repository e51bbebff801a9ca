// What a trace says of the run up to some event: where particles were, who was tethered, which bodies moved
// as one. Mutations choose by it where they can act, and with which numbers. It judges nothing.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/trace_check/broken_trace.hpp"

namespace tps::mutation {

/// A particle as of its last event.
struct Flight {
  Vec position, velocity;
  std::string t;
};

/// A load: the tree below it and what it weighs. A leaf is null; an infinite mass is no side at all.
struct Load {
  int i = 0, j = 0;
  std::shared_ptr<const Load> sides[2];
  std::vector<int> members[2];  ///< of the two bodies, ascending; empty for an infinite mass
  double mass[2];
  std::size_t line = 0;  ///< of the trace
};

class Retold {
 public:
  explicit Retold(const Trace& trace);

  /// Takes in one line of the trace.
  void hear(const Json& line, std::size_t number);

  const Flight& flight(int id) const { return flights_.at(id); }
  Vec position(int id, const Json& t) const;

  bool tethered(int i, int j) const { return tethers_.contains(std::minmax(i, j)); }
  /// Tethers of a particle that count towards its capacity.
  int tethers_of(int id) const;
  const std::set<std::pair<int, int>>& tethers() const { return tethers_; }

  const PairLaw* law(int i, int j) const;
  FormRule form_rule(int i, int j) const;
  BreakRule break_rule(int i, int j) const;
  bool is_permanent(int i, int j) const;

  double mass(int id) const;
  bool fixed(int id) const;
  double body_mass(int id) const;
  /// Who moves with a particle, itself included, ascending.
  std::vector<int> body(int id) const;
  /// The load that made a particle's body; null while it is on its own.
  std::shared_ptr<const Load> load(int id) const;
  const Species& species(int id) const;

 private:
  void load_bodies(const Json& event, std::size_t number);
  void part_bodies(const Json& event);
  const Phase* phase(int i, int j, bool forming) const;

  const Scene* scene_;
  std::map<int, const Particle*> particles_;
  std::map<int, Flight> flights_;
  std::set<std::pair<int, int>> tethers_;
  std::map<int, std::shared_ptr<const Load>> loads_;
  std::set<std::size_t> phases_;
};

/// One event of a trace with what went before.
struct Place {
  const Trace& trace;
  const Retold& before;
  const Json& event;
  const Json* previous;  ///< event; null for the first one
  const Json* next;      ///< event; null for the last one
  std::size_t line;
  std::size_t next_line;  ///< of `next`; 0 if there is none

  /// Whether nothing stands between this event and the next one.
  bool next_follows_at_once() const { return next != nullptr && next_line == line + 1; }

  int i() const { return event.at("i"); }
  int j() const { return event.at("j"); }
  /// Time to the events around; to the start before the first one, infinite after the last one.
  double since_previous() const;
  double until_next() const;
  Vec pre(int id, const char* what) const { return numbers(event.at("pre").at(key(id)).at(what)); }
  Vec post(int id, const char* what) const { return numbers(event.at("post").at(key(id)).at(what)); }
  /// Unit vector from i to j.
  Vec axis() const;
  /// v_j − v_i before, of the bodies.
  Vec approach() const { return pre(j(), "velocity") - pre(i(), "velocity"); }
  double normal_speed() const { return dot(approach(), axis()); }
  /// Whether a displacement is far beyond what storing the pair's positions rounds away.
  bool visible(double distance) const;
};

/// The line of one of the events that meet a condition, and what went before it; which one, `number` decides.
struct Found {
  std::size_t line;
  Retold before;
};
template <typename Condition>
std::optional<Found> find_event(const Trace& trace, std::uint64_t number, Condition meets);

std::size_t chosen(std::size_t candidates, std::uint64_t number);
Place place_at(const Trace& trace, const std::vector<std::size_t>& events, std::size_t n,
               const Retold& before);

template <typename Condition>
std::optional<Found> find_event(const Trace& trace, std::uint64_t number, Condition meets) {
  const std::vector<std::size_t> events = event_lines(trace);
  std::vector<std::size_t> candidates;
  Retold told(trace);
  for (std::size_t n = 0; n < events.size(); ++n) {
    if (meets(place_at(trace, events, n, told))) candidates.push_back(events[n]);
    told.hear(trace.lines[events[n]], events[n]);
  }
  if (candidates.empty()) return std::nullopt;
  const std::size_t line = candidates[chosen(candidates.size(), number)];
  Found found{line, Retold(trace)};
  for (std::size_t n = 0; n < line; ++n) found.before.hear(trace.lines[n], n);
  return found;
}

/// The place of an event that was found. REQUIRES that the trace is as it was.
Place place_of(const Trace& trace, const Found& found);

}  // namespace tps::mutation
