// Bodies that do not load, expire or part as their tree says (semantics §4).
#include <algorithm>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

bool is_restitution(const Json& line) {
  return is_event(line) && line.at("kind") == "restitute";
}

std::shared_ptr<const Load> load_of(const Place& place) {
  return place.before.load(place.before.fixed(place.i()) ? place.j() : place.i());
}

/// The first restitution of a body.
bool parts_root(const Place& place) {
  if (!is_restitution(place.event)) return false;
  const Json* before = place.previous;
  return before == nullptr || !is_restitution(*before) || place.since_previous() > 0;
}

/// The lines from a root's restitution to the last of its nodes.
std::size_t behind_tree(const Trace& trace, std::size_t root, std::size_t nodes) {
  std::size_t line = root;
  for (std::size_t seen = 0; line < trace.lines.size() && seen < nodes; ++line) {
    if (is_restitution(trace.lines[line])) ++seen;
  }
  return line;
}

std::size_t nodes_of(const Load& load) {
  std::size_t nodes = 1;
  for (const auto& side : load.sides) nodes += side ? nodes_of(*side) : 0;
  return nodes;
}

bool parts_a_body(const Place& place) {
  return parts_root(place) && load_of(place) != nullptr && length(numbers(place.event.at("dp"))) > 0;
}

double grain(const Place& place) {
  return since_start(place.trace, place.event.at("t")) * std::max(1e-9, 4096 * epsilon(place.trace));
}

Broken restitution_forgotten(Trace& trace, std::uint64_t number) {
  const auto followed = [](const Place& p) {
    if (!parts_a_body(p)) return false;
    const std::size_t end = behind_tree(p.trace, p.line, nodes_of(*load_of(p)));
    for (std::size_t n = end; n < p.trace.lines.size(); ++n) {
      if (is_event(p.trace.lines[n])) return elapsed(p.event.at("t"), p.trace.lines[n].at("t")) > grain(p);
    }
    return false;
  };
  return at_event(trace, number, followed, [&](std::size_t n, const Retold& before) {
    const Json& event = trace.lines[n];
    const int i = event.at("i");
    const auto load = before.load(before.fixed(i) ? event.at("j").get<int>() : i);
    const std::size_t end = behind_tree(trace, n, nodes_of(*load));
    for (std::size_t line = end; line-- > n;) {
      if (is_restitution(trace.lines[line])) erase_line(trace, line);
    }
    settle(trace);
  });
}

bool parts_nested(const Place& place) {
  return parts_a_body(place) && nodes_of(*load_of(place)) > 1;
}

Broken node_forgotten(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, parts_nested);
  if (!found) return {};
  std::size_t line = found->line + 1;
  while (!is_restitution(trace.lines[line])) ++line;
  const std::uint64_t k = number_of(trace, line);
  erase_line(trace, line);
  settle(trace);
  return k;
}

/// The child first, then the root, with the velocities that this leaves at each: the end is the same.
Broken unwound_from_the_leaves(Trace& trace, std::uint64_t number) {
  const auto followed_by_child = [](const Place& p) {
    return parts_nested(p) && p.next_follows_at_once() && is_restitution(*p.next) && p.until_next() == 0;
  };
  const auto found = find_event(trace, number, followed_by_child);
  if (!found) return {};
  const Json root = trace.lines[found->line];
  const Json child = trace.lines[found->line + 1];
  const int i = root.at("i");
  const auto load = found->before.load(found->before.fixed(i) ? root.at("j").get<int>() : i);
  const int child_i = child.at("i");
  const int child_member = found->before.fixed(child_i) ? child.at("j").get<int>() : child_i;
  const auto below = std::find_if(std::begin(load->sides), std::end(load->sides), [&](const auto& side) {
    return side && (std::ranges::count(side->members[0], child_member) +
                    std::ranges::count(side->members[1], child_member)) > 0;
  });
  std::map<int, Vec> velocity;
  for (const auto& side : load->members) {
    for (const int id : side) velocity[id] = found->before.flight(id).velocity;
  }
  const auto part = [&](Json event, const Load& node) {
    const Vec dp = numbers(event.at("dp"));
    const int pair[2] = {node.i, node.j};
    for (int side = 0; side < 2; ++side) {
      Json& before = event["pre"][key(pair[side])]["velocity"];
      if (node.members[side].empty()) continue;
      before = spelt(trace, velocity[pair[side]]);
      const Vec change = dp / (side == 0 ? node.mass[side] : -node.mass[side]);
      const Vec after = velocity[pair[side]] + change;
      event["post"][key(pair[side])]["velocity"] = spelt(trace, after);
      for (const int id : node.members[side]) velocity[id] = after;
    }
    return event;
  };
  trace.lines.change(found->line) = part(child, **below);
  trace.lines.change(found->line + 1) = part(root, *load);
  settle(trace);
  return number_of(trace, found->line);
}

/// Moves the whole unwinding of a body, with everybody where the flight leads by then.
void move_tree(Trace& trace, std::size_t root, const Retold& before, std::size_t nodes, double since) {
  const std::size_t end = behind_tree(trace, root, nodes);
  for (std::size_t line = root; line < end; ++line) {
    if (is_restitution(trace.lines[line])) carry_event(trace, line, before, since);
  }
}

Broken restitution_late(Trace& trace, std::uint64_t number) {
  const auto has_time = [](const Place& p) {
    if (!parts_a_body(p)) return false;
    const std::size_t end = behind_tree(p.trace, p.line, nodes_of(*load_of(p)));
    const double late = end < p.trace.lines.size() && is_event(p.trace.lines[end])
                            ? elapsed(p.event.at("t"), p.trace.lines[end].at("t"))
                            : 0;
    return late > 4 * grain(p);
  };
  const auto found = find_event(trace, number, has_time);
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const double since = since_start(trace, place.event.at("t")) + grain(place);
  move_tree(trace, found->line, found->before, nodes_of(*load_of(place)), since);
  return number_of(trace, found->line);
}

Broken restitution_early(Trace& trace, std::uint64_t number) {
  const auto found = find_event(
      trace, number, [](const Place& p) { return parts_a_body(p) && p.since_previous() > 4 * grain(p); });
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const double since = since_start(trace, place.event.at("t")) - grain(place);
  move_tree(trace, found->line, found->before, nodes_of(*load_of(place)), since);
  return number_of(trace, found->line);
}

/// The time at which the oldest load below a body would have parted it, had no merge renewed its expiry.
double first_expiry(const Trace& trace, const Load& load) {
  double first = since_start(trace, trace.lines[load.line].at("t")) + trace.scene.grouping->dt_restitute;
  for (const auto& side : load.sides) first = side ? std::min(first, first_expiry(trace, *side)) : first;
  return first;
}

Broken expiry_not_renewed(Trace& trace, std::uint64_t number) {
  const auto renewed = [](const Place& p) {
    if (!parts_nested(p)) return false;
    const double expiry = first_expiry(p.trace, *load_of(p));
    const double now = since_start(p.trace, p.event.at("t"));
    return now - p.since_previous() < expiry && expiry < now - grain(p);
  };
  const auto found = find_event(trace, number, renewed);
  if (!found) return {};
  const auto load = load_of(place_of(trace, *found));
  move_tree(trace, found->line, found->before, nodes_of(*load), first_expiry(trace, *load));
  return number_of(trace, found->line);
}

}  // namespace

const std::vector<Mutation>& broken_groups() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"restitution_forgotten", "a body is not parted at its expiry", earliest, restitution_forgotten},
      {"node_forgotten", "a body is parted, but one node of it", groups, node_forgotten},
      {"unwound_from_the_leaves", "a child is parted before the root", groups, unwound_from_the_leaves},
      {"restitution_late", "a body is parted 1e-9 of the time too late", groups, restitution_late},
      {"restitution_early", "a body is parted 1e-9 of the time too early", groups, restitution_early},
      {"expiry_not_renewed", "a body is parted at the expiry of its first load", groups, expiry_not_renewed},
  };
  return list;
}

}  // namespace tps::mutation
