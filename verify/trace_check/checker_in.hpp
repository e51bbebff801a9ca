// Checker, included by the instantiating sources only.
#pragma once

#include "verify/trace_check/checker.hpp"

namespace tps::check {

template <typename Number>
Checker<Number>::Checker(const TraceFacts& facts, const Precision<Number>& precision, Tally& tally)
    : model_(facts.scene, precision),
      tally_(tally),
      timing_(facts.timing),
      minimal_(facts.minimal),
      context_{model_,          tally_,         timing_,
               minimal_,        exact_,         [this](const Instant<Number>& t) { return shown_time(t); },
               facts.semantics, facts.own_draws},
      neighbours_(facts.scene),
      permanent_(facts.scene.particles.size()) {
  const Scene& scene = facts.scene;
  model_.eager = facts.eager;
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
    place(i, {});
  }
}

/// Which exact moment an event stands for, where the trace claims exact order.
template <typename Number>
Happening<Number> Checker<Number>::happening_of(const EventLine<Number>& event) {
  Happening<Number> happening;
  happening.t = event.t;
  if (is_collision(event.kind)) {
    happening.i = event.i;
    happening.j = event.j;
    happening.outer = event.kind != Kind::rebound;
  }
  if constexpr (std::is_same_v<Number, double>) {
    if (timing_ != Timing::certified) return happening;
    const auto known = [](const Instant<double>& t) { return Moment{t.hi, t.lo, std::nullopt, 1}; };
    if (is_collision(event.kind)) {
      const auto limit = limit_of(model_, event);
      const PairFlight<double> pair = pair_flight(model_, event.i, event.j);
      if (!limit || event.t < pair.start) return happening;
      const TimingQuery query = timing_query(pair, happening.outer, static_cast<double>(limit->L));
      if (!valid(query)) return happening;
      const TimingVerdict verdict = exact_.answer(query).verdict;
      if (!occurs(verdict)) return happening;
      const int multiple = limit->responded && verdict == TimingVerdict::turning ? 2 : 1;
      happening.moment = Moment{pair.start.hi, pair.start.lo, query, multiple};
    } else if (event.kind == Kind::restitute) {
      const Body<double>* body = model_.groups.with_root(event.i, event.j);
      happening.moment =
          known(body != nullptr && !model_.groups.is_parting(body) ? expiry_of(model_, *body) : event.t);
    } else if (is_phase(event.kind) && model_.phases_done < model_.phase_changes.size()) {
      happening.moment =
          known(known_time<double>(model_.phase_changes[model_.phases_done].at, model_.precision));
    } else if (model_.impulses_done < model_.impulses.size()) {
      happening.moment =
          known(known_time<double>(model_.impulses[model_.impulses_done].at, model_.precision));
    }
  }
  return happening;
}

template <typename Number>
void Checker<Number>::place(int i, const Instant<Number>& now) {
  const Vec<W> x = model_.position(i, now);
  const Flight<Number>& f = model_.flight(i);
  Coordinates position{}, velocity{};
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] = static_cast<double>(x[k]);
    velocity[k] = static_cast<double>(f.velocity[k]);
  }
  neighbours_.place(i, position, velocity, static_cast<double>(now.hi));
}

template <typename Number>
void Checker<Number>::judge_meeting(int i, int j, const Instant<Number>& until,
                                    const Happening<Number>& happening) {
  if (i == j) return;
  const int a = std::min(i, j);
  const int b = std::max(i, j);
  const auto flight = std::tuple(a, b, model_.revisions[static_cast<std::size_t>(a)],
                                 model_.revisions[static_cast<std::size_t>(b)]);
  const auto known = told_.empty() ? told_.end() : told_.find(flight);
  Told told = known == told_.end() ? Told{} : known->second;
  const Asked asked = judge_pair(context_, a, b, until, happening, told);
  earliest_held_ = earliest_held_ && asked.earliest;
  bounds_held_ = bounds_held_ && asked.bounds;
  if (asked.earliest && asked.bounds) return;
  constexpr std::size_t kKept = 100'000;
  if (told_.size() > kKept) told_.clear();
  told_[flight] = told;
}

/// Everybody whom a particle can have met since the later of the two anchors, and its tethered partners.
template <typename Number>
void Checker<Number>::judge_meetings(int i, const Instant<Number>& until,
                                     const Happening<Number>& happening) {
  for (const int j : neighbours_.near(i)) judge_meeting(i, j, until, happening);
  for (const int j : model_.tethers[static_cast<std::size_t>(i)]) judge_meeting(i, j, until, happening);
  for (const int j : permanent_[static_cast<std::size_t>(i)]) judge_meeting(i, j, until, happening);
}

template <typename Number>
void Checker<Number>::judge_everyone(const Instant<Number>& until, const Happening<Number>& happening) {
  for (int i = 0; i < model_.size(); ++i) {
    for (int j = i + 1; j < model_.size(); ++j) judge_meeting(i, j, until, happening);
  }
}

/// Particles that leave their anchors are judged where they were and get new ones. Where that becomes endless
/// (a long flight through a fine grid) everybody is asked once instead.
template <typename Number>
void Checker<Number>::renew_anchors(const Instant<Number>& until, const Happening<Number>& happening) {
  const double end = static_cast<double>(until.hi);
  std::uint64_t left = 1000 + 64 * model_.flights.size();
  while (const auto expired = neighbours_.expiry_until(end)) {
    if (--left == 0) {
      judge_everyone(until, happening);
      for (int i = 0; i < model_.size(); ++i) place(i, until);
      return;
    }
    const Instant<Number> now{Number(expired->t), Number(0)};
    const Instant<Number>& since = model_.flight(expired->particle).since;
    if (since < now) judge_meetings(expired->particle, now, happening);
    place(expired->particle, since < now ? now : since);
  }
}

/// Who begins a new flight at an event: those listed; at a restitution both sides of the node.
template <typename Number>
std::vector<int> Checker<Number>::changing(const EventLine<Number>& event) const {
  std::set<int> all;
  for (const InvolvedParticle<Number>& p : event.involved) all.insert(p.particle);
  if (event.kind == Kind::restitute) {
    if (const Body<Number>* body = model_.groups.with_root(event.i, event.j)) {
      all.insert(body->members.begin(), body->members.end());
    }
  }
  return {all.begin(), all.end()};
}

template <typename Number>
void Checker<Number>::judge_collision(const Context<Number>& c, const EventLine<Number>& event) {
  judge_contact(c, event);
  judge_approach(c, event, *bodies_);
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
  judge_free_velocities(c, event, *bodies_, expected_);
  if (event.kind != Kind::broken) judge_direction(c, event, event.kind != Kind::rebound);
  if (event.kind != Kind::broken) judge_conservation(c, event, *bodies_, expected_);
}

template <typename Number>
void Checker<Number>::take(const EventLine<Number>& event) {
  const Context<Number>& c = context_;
  if (ended_) {
    tally_.demand(Rule::end, false, [](Finding& f) { f.message = "an event behind the end of the trace"; });
  }
  model_.asked = event.t;
  const Happening<Number> happening = happening_of(event);
  judge_order(c, event);
  judge_parting(c, event);
  judge_known_events(c, event, happening);
  judge_flight(c, event);
  judge_bystanders(c, event);
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
  if (event.kind == Kind::scheduled_impulse) {
    judge_members(c, event, false, Expected<W>{});
    judge_scheduled_impulse(c, event);
  }
  if (is_phase(event.kind)) judge_phase(c, event);

  earliest_held_ = bounds_held_ = true;
  if (!(event.t < model_.now)) {
    renew_anchors(event.t, happening);
    for (const int i : changing(event)) judge_meetings(i, event.t, happening);
  }
  if (earliest_held_) tally_.pass(Rule::earliest);
  if (bounds_held_) tally_.pass(Rule::bounds);

  follow(event);
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
  StateJudge<Number>(c, state).judge();
}

template <typename Number>
void Checker<Number>::take(const EndLine<Number>& end) {
  const Context<Number>& c = context_;
  if (ended_) {
    tally_.demand(Rule::end, false, [](Finding& f) { f.message = "a second end"; });
    return;
  }
  ended_ = true;
  model_.asked = end.t;
  judge_end(c, end);
  Happening<Number> happening;
  happening.t = end.t;
  if (end.t < model_.now) return;
  earliest_held_ = bounds_held_ = true;
  EventLine<Number> nothing;
  nothing.kind = Kind::broken;
  nothing.t = end.t;
  judge_parting(c, nothing);
  if (end.reason == "duration") judge_known_events(c, nothing, happening);
  if (end.reason == "no_more_events") {
    const std::size_t waiting = model_.phase_changes.size() - model_.phases_done + model_.impulses.size() -
                                model_.impulses_done + model_.groups.size();
    tally_.demand(Rule::earliest, waiting == 0, [&](Finding& f) {
      f.message = fmt::format(
          "{} bodies, scheduled impulses or phase changes still wait, but no more events are claimed",
          waiting);
    });
    constexpr int kAtMost = 20'000;
    if (model_.size() > kAtMost) {
      tally_.not_judged(Rule::end, "that nothing more happens is not judged for more than 20000 particles");
    } else {
      const Instant<Number> never{Number(std::numeric_limits<double>::max()), Number(0)};
      happening.t = never;
      happening.forever = true;
      judge_everyone(never, happening);
    }
  } else {
    renew_anchors(end.t, happening);
    for (int i = 0; i < model_.size(); ++i) judge_meetings(i, end.t, happening);
  }
  if (earliest_held_) tally_.pass(Rule::earliest);
  if (bounds_held_) tally_.pass(Rule::bounds);
}

template <typename Number>
void Checker<Number>::close() {
  tally_.demand(Rule::end, ended_, [](Finding& f) {
    f.message =
        "the trace has no end: the run was killed, or could not write; everything up to here was judged";
  });
}

}  // namespace tps::check
