// Checker, included by the instantiating sources only.
#pragma once

#include "verify/trace_check/checker.hpp"
#include "verify/trace_check/effect_rules_catalogue.hpp"

namespace tps::check {

template <typename Number>
Checker<Number>::Checker(const TraceFacts& facts, const Precision<Number>& precision, Tally& tally,
                         const std::optional<TakenUp<Number>>& taken_up)
    : model_(facts.scene, precision),
      tally_(tally),
      timing_(facts.timing),
      minimal_(facts.minimal),
      turns_(exact_, border_of(taken_up, precision)),
      context_{model_,
               tally_,
               timing_,
               minimal_,
               exact_,
               turns_,
               [this](const Instant<Number>& t) { return shown_time(t); },
               facts.semantics,
               facts.own_draws},
      neighbours_(facts.scene, as_double(precision.u)),
      permanent_(facts.scene.particles.size()),
      agendas_(facts.scene.particles.size()),
      looks_(facts.scene.particles.size(), 0),
      told_(facts.scene.particles.size()) {
  const Scene& scene = facts.scene;
  model_.eager = facts.eager;
  model_.effects = all_effect_rules<Number>(facts.scene);
  waits_.changed_at.resize(scene.particles.size(), 0);
  if (taken_up) {
    restore(context_, taken_up->state);
    if (taken_up->waits != nullptr) waits_ = *taken_up->waits;
  }
  for (std::size_t k = 0; model_.edges && k < 3; ++k) edges_[k] = as_double((*model_.edges)[k]);
  std::vector<std::vector<int>> of_species(scene.species.size());
  for (int n = 0; n < model_.size(); ++n) {
    of_species[static_cast<std::size_t>(scene.particles[static_cast<std::size_t>(n)].species)].push_back(n);
  }
  for (int i = 0; i < model_.size(); ++i) {
    for (const std::vector<int>& others : of_species) {
      if (others.empty() || !model_.rules.of(i, others.front()).permanent) continue;
      for (const int j : others) {
        if (j != i) permanent_[static_cast<std::size_t>(i)].push_back(j);
      }
    }
    place(i, model_.now);
  }
  make_agendas(facts);
}

/// For those who never begin another flight and have so many partners that an event should not ask them all.
template <typename Number>
void Checker<Number>::make_agendas(const TraceFacts& facts) {
  constexpr std::size_t kMany = 64;
  if (minimal_ || facts.eager || model_.edges) return;
  for (int i = 0; i < model_.size(); ++i) {
    const std::vector<int>& partners = permanent_[Model<Number>::at(i)];
    if (model_.fixed(i) && partners.size() >= kMany)
      agendas_[Model<Number>::at(i)].emplace(partners, agendas_.size());
  }
  for (int i = 0; i < model_.size(); ++i) {
    if (agendas_[Model<Number>::at(i)]) with_agenda_.push_back(i);
  }
}

/// The turn of the event: under certified timing the exact moment that its time rounds. Where it has none (a
/// pair that never gets there; other rules say so) its recorded time stands for it.
template <typename Number>
Turn<Number> Checker<Number>::turn_of_event(const EventLine<Number>& event) {
  const Context<Number>& c = context_;
  if (event.kind == Kind::restitute) {
    const Body<Number>* body = model_.groups.with_root(event.i, event.j);
    if (body == nullptr) return known_turn(c, event.t, kRankOfRestitution, event.i);
    Turn<Number> turn = turn_of(c, *body);
    turn.t = event.t;
    return turn;
  }
  if (const EffectRules<Number>* effect = model_.effect_of(event.kind)) {
    const std::optional<EventAhead> ahead = effect->next(c);
    Turn<Number> turn = ahead ? turn_of(c, *effect, *ahead) : known_turn(c, event.t, effect->rank());
    turn.t = event.t;
    return turn;
  }
  if (event.kind == Kind::wall) return turn_at_wall(event);
  if constexpr (std::is_same_v<Number, double>) {
    if (arrival_) {
      const LimitFlight<double>& flight = arrival_->flight;
      auto turn = detail::certified_turn(c, flight.pair, event.i, event.j, flight.asked, arrival_->certified);
      if (turn) {
        turn->t = event.t;
        return *turn;
      }
    }
  }
  Turn<Number> turn = known_turn(c, event.t, kRankOfPair);
  turn.first = event.i;
  turn.second = event.j;
  return turn;
}

/// The same of a particle that meets a wall.
template <typename Number>
Turn<Number> Checker<Number>::turn_at_wall(const EventLine<Number>& event) {
  const Context<Number>& c = context_;
  Turn<Number> turn = known_turn(c, event.t, kRankAtWall, event.i);
  if constexpr (std::is_same_v<Number, double>) {
    const std::optional<std::size_t> n = model_.wall_of(event);
    if (c.certified() && n && !model_.fixed(event.i)) {
      const auto exact = certified_turn(c, wall_flight(c, event.i, *n));
      if (exact) turn = *exact;
      turn.t = event.t;
    }
  }
  return turn;
}

/// Of a kind whose effect a program brought along without rules, or not in the numbers of this trace.
template <typename Number>
void Checker<Number>::say_unknown(Kind kind) {
  const std::string why =
      fmt::format("the check has no rules for events of kind {} in this scalar", name(kind));
  for (const Rule rule : {Rule::order, Rule::impulse, Rule::earliest}) tally_.not_judged(rule, why);
}

template <typename Number>
bool Checker<Number>::is_now_by_rounding(const Instant<Number>& t) const {
  return minimal_ && t < model_.now && elapsed(t, model_.now) <= context_.time_error(model_.now);
}

/// Judges whether it was this event's turn, and whether that of anything known in advance had come before.
/// The nodes of one restitution are one step.
template <typename Number>
void Checker<Number>::take_turn(const EventLine<Number>& event) {
  const Context<Number>& c = context_;
  if (!model_.groups.parting().empty()) return;
  if (is_of_effect(event.kind) && model_.effect_of(event.kind) == nullptr) return say_unknown(event.kind);
  ++waits_.step;
  const Turn<Number> turn = turn_of_event(event);
  const auto changed_at = [this](int i) {
    return i < 0 ? StepNumber(0) : waits_.changed_at[Model<Number>::at(i)];
  };
  StepNumber since = std::max(changed_at(turn.first), changed_at(turn.second));
  const EffectRules<Number>* effect = model_.effect_of(event.kind);
  if (effect != nullptr)
    since = std::exchange(waits_.acted_at[{effect->effect(), effect->waits_for(event)}], waits_.step);
  if (event.t < model_.now) turns_.forget();
  judge_turn(c, event, turn, since);
  turns_.happened(waits_.step, turn);
  judge_known_events(c, event, turn);
}

/// Who begins a new flight at an event: those listed; at a restitution both sides of the node, at some
/// effects' everybody.
template <typename Number>
const std::vector<int>& Checker<Number>::changing(const EventLine<Number>& event) {
  std::vector<int>& all = changing_;
  all.clear();
  for (const InvolvedParticle<Number>& p : event.involved) all.push_back(p.particle);
  if (event.kind == Kind::restitute) {
    if (const Body<Number>* body = model_.groups.with_root(event.i, event.j))
      all.insert(all.end(), body->members.begin(), body->members.end());
  }
  const EffectRules<Number>* effect = model_.effect_of(event.kind);
  if (effect != nullptr && effect->moves_everybody()) {
    for (int i = 0; i < model_.size(); ++i) {
      if (!model_.fixed(i)) all.push_back(i);
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

template <typename Number>
void Checker<Number>::judge_collision(const Context<Number>& c, const EventLine<Number>& event) {
  judge_contact(c, event, arrival_);
  if (event.kind == Kind::rebound) below_rounding_.look(c, *bodies_);
  if (arrival_) judge_approach(c, event, arrival_->flight, *bodies_);
  expected_ = expected_of(c, event, *bodies_);
  if (event.kind == Kind::retract || event.kind == Kind::revolve) judge_kind(c, event, *bodies_);
  judge_dp(c, event, *bodies_, expected_);
  judge_members(c, event, true, expected_);
  if (event.kind == Kind::rebound) {
    judge_forming(c, event);
  } else {
    judge_breaking(c, event, expected_);
  }
  if (is_load(c, event, expected_)) {
    judge_load(c, event, *bodies_, expected_);
    judge_load_conservation(c, event, *bodies_);
    return;
  }
  if (event.kind == Kind::broken) return judge_unchanged(c, event);
  const Exchange<W> exchange = exchange_of(c, event, *bodies_, expected_);
  judge_free_velocities(c, event, *bodies_, expected_, exchange);
  judge_direction(c, event, event.kind != Kind::rebound);
  judge_conservation(c, event, *bodies_, expected_, exchange);
  if (event.kind == Kind::rebound && model_.rules.of(event.i, event.j).rubs)
    judge_friction(c, event, *bodies_, expected_, rough_now(c, *bodies_));
}

template <typename Number>
void Checker<Number>::take(const EventLine<Number>& event) {
  const Context<Number>& c = context_;
  if (is_now_by_rounding(event.t)) {
    EventLine<Number> at_once = event;
    at_once.t = model_.now;
    return take(at_once);
  }
  if (ended_) {
    tally_.demand(Rule::end, false, [](Finding& f) { f.message = "an event behind the end of the trace"; });
  }
  model_.asked = event.t;
  arrival_.reset();
  if (is_collision(event.kind)) arrival_ = arrival_of(c, event);
  expect(event);
  judge_order(c, event);
  judge_drag_time(c, Rule::order, event.t, event.time);
  judge_parting(c, event);
  take_turn(event);
  judge_flight(c, event);
  judge_bystanders(c, event);
  judge_spins_listed(c, event);
  bodies_.reset();
  expected_ = {};
  if (event.j >= 0) bodies_ = bodies_now(model_, event, c.time_error(event.t));
  const bool both_fixed = event.j >= 0 && model_.fixed(event.i) && model_.fixed(event.j);
  tally_.demand(Rule::contact, !both_fixed, [&](Finding& f) {
    f.message = fmt::format("{} have infinite masses; two of them never interact", c.pair(event.i, event.j));
  });
  const bool apart = !both_fixed && (!bodies_ || bodies_->distance() > W(0));
  tally_.demand(Rule::contact, apart || both_fixed, [&](Finding& f) {
    f.message = fmt::format("{} are at one point, so that û is not defined", c.pair(event.i, event.j));
  });
  if (apart && is_collision(event.kind)) judge_collision(c, event);
  if (apart && event.kind == Kind::restitute) {
    judge_members(c, event, false, Expected<W>{});
    judge_restitution(c, event, *bodies_);
  }
  if (is_kick(event.kind)) judge_members(c, event, false, Expected<W>{});
  if (event.kind == Kind::wall) judge_wall_rebound(c, event);
  if (const EffectRules<Number>* effect = model_.effect_of(event.kind)) effect->judge(c, event);

  const std::vector<int>& changed = changing(event);
  earliest_held_ = bounds_held_ = true;
  arrival_is_judged_ = false;
  if (!(event.t < model_.now)) {
    Happening<Number> happening;
    happening.t = event.t;
    if (is_collision(event.kind)) {
      happening.i = event.i;
      happening.j = event.j;
      happening.outer = event.kind != Kind::rebound;
    }
    if (event.kind == Kind::wall) {
      happening.i = event.i;
      happening.wall = model_.wall_of(event);
    }
    renew_anchors(event.t, happening);
    for (const int i : changed) {
      judge_meetings(i, event.t, happening);
      judge_at_walls(i, event.t, happening);
    }
  }
  if (earliest_held_) tally_.pass(Rule::earliest);
  if (bounds_held_) tally_.pass(Rule::bounds);

  follow(event, changed);
  judge_progress(c, event);
}

template <typename Number>
void Checker<Number>::take(const StateLine<Number>& state) {
  if (ended_) {
    tally_.demand(Rule::end, false,
                  [](Finding& f) { f.message = "a full state behind the end of the trace"; });
  }
  const Context<Number>& c = context_;
  if (minimal_) return;
  state_holds_ = StateJudge<Number>(c, state).judge();
}

template <typename Number>
void Checker<Number>::close() {
  tally_.demand(Rule::end, ended_, [&](Finding& f) {
    f.message = end_is_unreadable_
                    ? "the line that says the end is not what an end is (rule schema): how the run ended was "
                      "not judged, everything before it was"
                    : "the trace has no end: the run was killed, or could not write; everything up to here "
                      "was judged";
  });
}

}  // namespace tps::check
