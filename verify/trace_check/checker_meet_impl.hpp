// How Checker finds out which pairs can have met, and asks each. Included by the instantiating sources only.
#pragma once

#include <span>

#include "verify/trace_check/checker.hpp"
#include "verify/trace_check/quiet.hpp"

namespace tps::check {

/// Asks memory for what is around the event's particles and what its residuals are added to.
template <typename Number>
void Checker<Number>::expect(const EventLine<Number>& event) const {
  for (const int i : {event.i, event.j}) {
    if (i >= 0) neighbours_.fetch(i);
  }
  neighbours_.fetch_next(as_double(event.t.hi));
  if (event.j < 0 || !event.dp) return;
  const double size = as_double(largest(*event.dp));
  tally_.expect_residual(Quantity::energy, size);
  tally_.expect_residual(Quantity::momentum, size);
  if (!arrival_) return;
  const double dt = as_double(arrival_->flight.dt);
  tally_.expect_asked(dt);
  tally_.expect_residual(Quantity::time, dt);
}

/// Where a particle is anchored. What double cannot hold of a speed may not get lost: 2^1000 times a vanished
/// one is a way.
template <typename Number>
void Checker<Number>::place(int i, const Instant<Number>& now) {
  const Vec<W> x = model_.position(i, now);
  const Flight<Number>& f = model_.flight(i);
  Coordinates position{}, velocity{};
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] = static_cast<double>(x[k]);
    velocity[k] = static_cast<double>(f.velocity[k]);
    if (velocity[k] == 0 && f.velocity[k] != Number(0))
      velocity[k] = std::numeric_limits<double>::denorm_min();
  }
  neighbours_.place(i, position, velocity, static_cast<double>(now.hi));
}

/// What holds for both flights: a wall never begins another one, so that only its partner's counts.
template <typename Number>
Told Checker<Number>::told_of(int i, int j) const {
  const auto of = [this](int a, int b) {
    const Told* const found = told_[Model<Number>::at(a)].find(b);
    return found == nullptr ? 0U : found->bits;
  };
  if (model_.fixed(i)) return {of(j, i)};
  if (model_.fixed(j)) return {of(i, j)};
  return {of(i, j) & of(j, i)};
}

template <typename Number>
void Checker<Number>::note_told(int i, int j, const Told& told) {
  if (!model_.fixed(i)) told_[Model<Number>::at(i)][j] = told;
  if (!model_.fixed(j)) told_[Model<Number>::at(j)][i] = told;
}

/// A first look in doubles at a particle beside others; nothing where the flights are not known as exactly as
/// it takes, or what is ahead has no end. Positions carried to the start of the flight have a few roundings
/// of the trace's scalar, thousands are allowed for. Where certified timing compares exact moments, they may
/// be behind the recorded ones by 1.1 u of them: the flight is looked at for so much longer.
template <typename Number>
std::optional<FirstLook> Checker<Number>::first_look(int i, const Instant<Number>& until,
                                                     const Happening<Number>& happening) const {
  if (happening.until == Until::ever || model_.eager) return std::nullopt;
  const Instant<double> end = rough(until);
  return FirstLook(model_.flight_in_doubles(i).until(end, longer(end)), 0x1p-104 * end.hi,
                   std::max(0x1p13 * as_double(context_.u()), 0x1p-40),
                   model_.edges ? edges_.data() : nullptr);
}

template <typename Number>
double Checker<Number>::longer(const Instant<double>& until) const {
  return context_.certified() ? 2 * as_double(context_.u()) * until.hi : 0;
}

template <typename Number>
bool Checker<Number>::is_clear(const FirstLook& look, int i, int j, const Instant<double>& until) const {
  const PairRules<Number>& rules = model_.rules.of(i, j);
  const bool tethered = rules.can_tether && model_.tethered(i, j);
  if (!rules.blocks && !tethered) return true;
  return look.is_clear(model_.flight_in_doubles(j).until(until, longer(until)),
                       {rules.blocks ? static_cast<double>(rules.inner) : -1.0,
                        tethered ? static_cast<double>(rules.outer) : -1.0});
}

/// Whether a pair has rebounded and flown apart since: then it is not asked, and no closer than at the start.
template <typename Number>
bool Checker<Number>::flew_apart(const FirstLook& look, int i, int j, const Instant<double>& until) const {
  const PairRules<Number>& rules = model_.rules.of(i, j);
  return rules.blocks && !model_.edges && model_.responded(i, j, false) && !model_.tethered(i, j) &&
         look.flew_apart(model_.flight_in_doubles(j).until(until, longer(until)));
}

template <typename Number>
void Checker<Number>::judge_meeting(int i, int j, const Instant<Number>& until,
                                    const Happening<Number>& happening) {
  const std::optional<FirstLook> look = first_look(i, until, happening);
  if (!look || !is_clear(*look, i, j, rough(until))) ask(i, j, until, happening);
}

/// Whether a pair is asked about nothing but the flight that ends with the collision that is being judged.
template <typename Number>
bool Checker<Number>::is_arrival_alone(int a, int b, const Instant<Number>& until,
                                       const Happening<Number>& happening) const {
  if (!arrival_ || !arrival_->is(a, b) || happening.until != Until::event || !(until == happening.t))
    return false;
  const LimitFlight<Number>& flight = arrival_->flight;
  const bool outer = flight.asked.outer;
  return !model_.edges && model_.rules.of(a, b).blocks != outer && model_.tethered(a, b) == outer &&
         !model_.groups.together(a, b) && !(until < flight.pair.start);
}

template <typename Number>
void Checker<Number>::ask(int i, int j, const Instant<Number>& until, const Happening<Number>& happening) {
  if (i == j) return;
  const int a = std::min(i, j);
  const int b = std::max(i, j);
  const bool arrives = is_arrival_alone(a, b, until, happening);
  if (arrives && arrival_is_judged_) return;
  arrival_is_judged_ = arrival_is_judged_ || arrives;
  Told told = told_of(a, b);
  const StepNumber since =
      std::max(waits_.changed_at[Model<Number>::at(a)], waits_.changed_at[Model<Number>::at(b)]);
  const Asked asked = arrives ? judge_limit(context_, arrival_->flight, false, since, happening, told)
                              : judge_pair(context_, a, b, until, since, happening, told);
  earliest_held_ = earliest_held_ && asked.earliest;
  bounds_held_ = bounds_held_ && asked.bounds;
  if (!asked.earliest || !asked.bounds) note_told(a, b, told);
}

/// Everybody whom a particle can have met since the later of the two anchors, and its tethered partners.
template <typename Number>
void Checker<Number>::judge_meetings(int i, const Instant<Number>& until,
                                     const Happening<Number>& happening) {
  const std::optional<FirstLook> look = first_look(i, until, happening);
  const Instant<double> end = rough(until);
  const double later = longer(end);
  const auto judge = [&](int j) {
    if (!look || !(is_clear(*look, i, j, end) || flew_apart(*look, i, j, end))) ask(i, j, until, happening);
  };
  const std::span<const int> near = neighbours_.near(i);
  for (const int j : near) __builtin_prefetch(&model_.flight_in_doubles(j));
  for (const int j : near) {
    const PairRules<Number>& rules = model_.rules.of(i, j);
    const bool blocks_only = look && rules.blocks && !rules.can_tether && !model_.edges;
    if (!blocks_only) {
      judge(j);
      continue;
    }
    const StraightLine line = model_.flight_in_doubles(j).until(end, later);
    if (look->is_clear_of_inner(line, as_double(rules.inner))) continue;
    if (!(model_.responded(i, j, false) && look->flew_apart(line))) ask(i, j, until, happening);
  }
  for (const int j : model_.tethers[Model<Number>::at(i)]) judge(j);
  if (neighbours_.is_near_everybody(i)) return;
  std::optional<Agenda>& agenda = agendas_[Model<Number>::at(i)];
  if (!agenda || happening.until == Until::ever) {
    for (const int j : permanent_[Model<Number>::at(i)]) judge(j);
    return;
  }
  for (const auto& [j, roughly] : agenda->due(end.hi)) {
    const double quiet = roughly ? quiet_until(context_, i, j) : -HUGE_VAL;
    if (quiet > end.hi) {
      agenda->put_off(j, quiet);
      continue;
    }
    judge(j);
    const std::optional<double> about = roughly ? std::nullopt : quiet_until_about(context_, i, j);
    agenda->put_off(j, about ? *about : quiet_until(context_, i, j), about.has_value());
  }
}

/// What has been said about a particle and surface n is kept with what was said about it and particle −1 − n.
template <typename Number>
void Checker<Number>::judge_at_walls(int i, const Instant<Number>& until,
                                     const Happening<Number>& happening) {
  if (model_.fixed(i)) return;
  const StepNumber since = waits_.changed_at[Model<Number>::at(i)];
  SmallMap<int, Told>& told = told_[Model<Number>::at(i)];
  for (std::size_t n = 0; n < model_.walls.size(); ++n) {
    const int key = -1 - static_cast<int>(n);
    const Told* const found = told.find(key);
    Told said = found == nullptr ? Told{} : *found;
    const Asked asked = judge_wall_flight(context_, i, n, until, since, happening, said);
    earliest_held_ = earliest_held_ && asked.earliest;
    bounds_held_ = bounds_held_ && asked.bounds;
    if (!asked.earliest || !asked.bounds) told[key] = said;
  }
}

template <typename Number>
void Checker<Number>::judge_with_everybody(int i, const Instant<Number>& until,
                                           const Happening<Number>& happening) {
  for (int j = 0; j < model_.size(); ++j) judge_meeting(i, j, until, happening);
}

/// Particles that leave their anchors are judged where they were and get new ones. A particle that has looked
/// at as many others as there are (a long flight through a fine grid) is asked with everybody instead, once:
/// so it costs at most twice what the cheaper way does.
template <typename Number>
void Checker<Number>::renew_anchors(const Instant<Number>& until, const Happening<Number>& happening) {
  const double end = static_cast<double>(until.hi);
  std::vector<int> looked;
  while (const auto expired = neighbours_.expiry_until(end)) {
    const int i = expired->particle;
    neighbours_.fetch_next(end);
    const Instant<Number> now{Number(expired->t), Number(0)};
    const Instant<Number>& since = model_.flight(i).since;
    std::size_t& looks = looks_[Model<Number>::at(i)];
    if (looks == 0) looked.push_back(i);
    looks += neighbours_.near(i).size() + Neighbours::kCellsAround;
    if (looks >= looks_.size()) {
      judge_with_everybody(i, until, happening);
      place(i, until);
      continue;
    }
    if (since < now) judge_meetings(i, now, happening);
    place(i, since < now ? now : since);
  }
  for (const int i : looked) looks_[Model<Number>::at(i)] = 0;
}

}  // namespace tps::check
