// Rule groups: bodies load, expire and part as their tree says.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/conservation.hpp"
#include "verify/trace_check/rules/known_events.hpp"

namespace tps::check {

/// Whether this event is a collision that joins two bodies: in a grouped scene, where it has an impulse. For
/// a vanishing v_n the trace decides.
template <typename Number>
bool is_load(const Context<Number>& c, const EventLine<Number>& event,
             const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  if (!c.model.scene.grouping || !row(event.kind).responds) return false;
  if (!c.minimal) return !event.members.empty();
  if (largest(expected.response.dp) > W(4) * expected.response.error) return true;
  // A minimal trace says it by velocities: one for both, where there were two.
  const auto velocity = [&](int n, bool after) {
    const InvolvedParticle<Number>* p = after ? event.of(n) : nullptr;
    return p != nullptr ? p->velocity_after : c.model.flight(n).velocity;
  };
  return velocity(event.i, true) == velocity(event.j, true) &&
         velocity(event.i, false) != velocity(event.j, false);
}

/// The members of a body have one velocity, to the last bit.
template <typename Number>
void judge_common_velocity(const Context<Number>& c, const EventLine<Number>& event,
                           const std::vector<int>& members) {
  const InvolvedParticle<Number>* first = nullptr;
  for (const int n : members) {
    const InvolvedParticle<Number>* p = event.of(n);
    if (p == nullptr) continue;
    if (first == nullptr) first = p;
    c.tally.demand(Rule::groups, p->velocity_after == first->velocity_after, [&](Finding& f) {
      f.particles = {c.model.id(first->particle), c.model.id(n)};
      f.message = fmt::format("particles {} and {} are of one body and leave with different velocities",
                              c.model.id(first->particle), c.model.id(n));
      f.equation = "(6)";
    });
  }
}

/// At a restitution the other members of the two bodies have the velocities of i and j; they may be listed.
template <typename Number>
bool moves_with_a_side(const Context<Number>& c, const EventLine<Number>& event,
                       const InvolvedParticle<Number>& p) {
  const Body<Number>* body =
      event.kind == Kind::restitute ? c.model.groups.with_root(event.i, event.j) : nullptr;
  if (body == nullptr) return false;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<int>& members = body->root->members[side];
    if (!std::binary_search(members.begin(), members.end(), p.particle)) continue;
    const int of_pair = side == 0 ? event.i : event.j;
    c.tally.demand(Rule::groups, p.velocity_after == event.of(of_pair)->velocity_after, [&](Finding& f) {
      f.particles = {c.model.id(of_pair), c.model.id(p.particle)};
      f.message = fmt::format("particles {} and {} are of one body and leave with different velocities",
                              c.model.id(of_pair), c.model.id(p.particle));
      f.equation = "(3)";
    });
    return true;
  }
  return false;
}

/// Who is listed: everybody who changes velocity, and nobody else.
template <typename Number>
void judge_members(const Context<Number>& c, const EventLine<Number>& event, bool collides,
                   const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const bool loads = is_load(c, event, expected);
  const bool with_wall = loads && (model.fixed(event.i) || model.fixed(event.j));
  const bool whole_bodies = loads || is_kick(event.kind);
  std::vector<int> moving;
  moving.reserve(2);
  for (const int side : {event.i, event.j}) {
    if (side < 0) continue;
    if (!whole_bodies) {
      moving.push_back(side);
      continue;
    }
    const std::vector<int> all = model.members(side);
    moving.insert(moving.end(), all.begin(), all.end());
  }
  std::sort(moving.begin(), moving.end());
  const auto names = [&](const std::vector<int>& particles) {
    std::vector<std::int32_t> ids;
    for (const int n : particles) ids.push_back(model.id(n));
    return fmt::format("{}", fmt::join(ids, " "));
  };
  if (loads && !event.members.empty()) {
    c.tally.demand(Rule::groups, event.members == moving, [&](Finding& f) {
      f.message =
          fmt::format("the body is listed as {}; its members are {}", names(event.members), names(moving));
      if (with_wall) f.reading = readings::kWallInTree;
    });
  }
  if (whole_bodies && !c.minimal) judge_common_velocity(c, event, moving);
  for (const int n : moving) {
    if (event.of(n) != nullptr) continue;
    c.tally.demand(Rule::groups, false, [&](Finding& f) {
      f.message =
          fmt::format("particle {} moves with the others, but its velocity is not given", model.id(n));
    });
  }
  for (const InvolvedParticle<Number>& p : event.involved) {
    if (p.particle == event.i || p.particle == event.j ||
        std::binary_search(moving.begin(), moving.end(), p.particle) || moves_with_a_side(c, event, p))
      continue;
    c.tally.demand(Rule::bystanders, false, [&](Finding& f) {
      f.particles = {model.id(p.particle)};
      f.message = fmt::format("particle {} has no part in the event, but is listed", model.id(p.particle));
      if (with_wall || (model.scene.grouping && model.fixed(p.particle))) f.reading = readings::kWallInTree;
    });
  }
  if (!collides || event.kind == Kind::broken) return;
  c.tally.demand(Rule::groups, !model.groups.together(event.i, event.j), [&](Finding& f) {
    f.message = fmt::format("{} collide, but they are one body", c.pair(event.i, event.j));
  });
  if (loads && !c.minimal) {
    c.tally.demand(Rule::groups, event.dp_stored.has_value(), [&](Finding& f) {
      f.message = "a load without the impulse that it stores, \"dp_stored\"";
    });
  }
  const W noise = W(4) * expected.response.error;
  if (!c.minimal && model.scene.grouping && largest(expected.response.dp) > noise && !loads) {
    c.tally.demand(Rule::groups, false, [&](Finding& f) {
      f.message =
          fmt::format("{} collide in a scene with grouping, but are not loaded", c.pair(event.i, event.j));
      f.equation = "(6)";
    });
  }
  if (!model.scene.grouping) {
    c.tally.demand(Rule::groups, event.members.empty(), [&](Finding& f) {
      f.message = fmt::format("{} are loaded in a scene without grouping", c.pair(event.i, event.j));
    });
  }
}

/// Nothing else happens, and no time passes, while a body parts. `what` is something else.
template <typename Number>
void judge_parted(const Context<Number>& c, const char* what) {
  Model<Number>& model = c.model;
  if (model.groups.parting().empty()) return;
  const auto& parting = model.groups.parting();
  const Body<Number>* left = *std::min_element(
      parting.begin(), parting.end(),
      [](const Body<Number>* a, const Body<Number>* b) { return a->members.front() < b->members.front(); });
  c.tally.demand(Rule::groups, false, [&](Finding& f) {
    f.message = fmt::format("{} while the body of particle {} has {} loads left to part", what,
                            model.id(left->members.front()),
                            left->root->members[0].size() + left->root->members[1].size() - 1);
    f.equation = "(7)";
  });
  model.groups.forget_parting();
}
template <typename Number>
void judge_parting(const Context<Number>& c, const EventLine<Number>& event) {
  const GroupModel<Number>& groups = c.model.groups;
  if (event.kind == Kind::restitute && event.t == c.model.now) {
    const Body<Number>* body = groups.with_root(event.i, event.j);
    if (body == nullptr || groups.is_parting(body)) return;
  }
  judge_parted(c, "something else happens");
}

/// A node of a tree parts: root first, at the expiry, by the impulse that was stored.
template <typename Number>
void judge_restitution(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  const Body<Number>* body = model.groups.with_root(event.i, event.j);
  c.tally.demand(Rule::groups, body != nullptr, [&](Finding& f) {
    f.message = model.groups.together(event.i, event.j)
                    ? fmt::format("{} part before the loads above theirs", c.pair(event.i, event.j))
                    : fmt::format("{} part, but no load of the two is next", c.pair(event.i, event.j));
    f.equation = "(7)";
  });
  if (body == nullptr) return;
  if (!model.groups.is_parting(body)) {
    const Instant<Number> expiry = body->expiry;
    const W late = elapsed(expiry, event.t);
    const W error = c.time_error(event.t);
    const bool clock_had_passed =
        c.certified() && event.t == model.now && late > W(0) && late <= W(2.5) * c.u() * abs(W(event.t.hi));
    c.tally.demand(Rule::groups, abs(late) <= error || clock_had_passed, [&](Finding& f) {
      f.message = fmt::format("the body of particle {} expires at {} and parts {} {}",
                              model.id(body->members.front()), c.shown_time(expiry), shown(W(abs(late))),
                              late > W(0) ? "later" : "earlier");
      f.reading = reading_of_expiry(c, *body, event.t, late);
    });
  }
  const LoadNode<Number>& node = *body->root;
  const Vec<W> dp = node.recorded ? widened<W>(node.dp) : node.dp_exact;
  if (event.dp && node.recorded) {
    c.tally.demand(Rule::groups, *event.dp == node.dp, [&](Finding& f) {
      f.message = fmt::format("{} part with the impulse {}; the one stored was {}", c.pair(event.i, event.j),
                              shown(*event.dp, model.scene.dimension), shown(node.dp, model.scene.dimension));
      f.equation = "(7)";
    });
  }
  // Bodies have one velocity, but of a minimal trace that is what it says of each.
  BodiesNow<Number> sides = b;
  sides.inverse_i = node.inverse_mass[0];
  sides.inverse_j = node.inverse_mass[1];
  sides.mu = W(1) / (sides.inverse_i + sides.inverse_j);
  sides.loads = body->loads + 1;
  sides.speeds_at_load = node.speeds;
  const Exchange<W> exchange = exchange_of(c, event, sides, node.outer, dp, node.dp_error);
  judge_parted(c, event, sides, exchange);
  judge_direction(c, event, node.outer);
  judge_parting_conservation(c, event, sides, node, exchange);
}

}  // namespace tps::check
