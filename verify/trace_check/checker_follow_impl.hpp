// How Checker takes over what a line says, whatever the rules think of it. Included by the instantiating
// sources only.
#pragma once

#include "verify/trace_check/checker.hpp"

namespace tps::check {

template <typename Number>
void Checker<Number>::begin_flight(const EventLine<Number>& event, int i, const Vec<Number>& velocity,
                                   const W& drift) {
  const InvolvedParticle<Number>* p = event.of(i);
  const auto recorded = p == nullptr        ? std::optional<Vec<Number>>()
                        : p->position_after ? p->position_after
                                            : p->position_before;
  W blur(0);
  Vec<Number> position;
  if (recorded) {
    position = *recorded;
  } else {
    const Flight<Number>& flight = model_.flight(i);
    blur = model_.blur(i);
    position = carried(flight, event.t, model_.precision, blur);
    if (minimal_) {
      // The velocity changed at the time that `t` rounds: until then, or from then on, the other one acted.
      const Vec<W> change = widened<W>(velocity) - widened<W>(flight.velocity);
      blur += context_.time_error(event.t) * length(change) +
              W(2) * model_.precision.u * largest(widened<W>(position));
    }
  }
  model_.set_flight(i, position, velocity, event.t, blur, drift);
}

/// A velocity that no line says. A minimal trace may be of a program that rounds it otherwise: as v + n g δ,
/// or with another rounding of the product or the sum. Ours has u of Δv and u of v', theirs up to 2u and u.
template <typename Number>
void Checker<Number>::follow_unsaid(const EventLine<Number>& event, int i, const Vec<Number>& velocity) {
  if (!minimal_) return begin_flight(event, i, velocity);
  const Flight<Number>& before = model_.flight(i);
  const Vec<W> change = widened<W>(velocity) - widened<W>(before.velocity);
  const W rounding = W(3) * length(change) + W(2) * length(widened<W>(velocity));
  begin_flight(event, i, velocity, W(before.drift + model_.precision.u * rounding));
}

template <typename Number>
void Checker<Number>::follow_load(const EventLine<Number>& event) {
  auto node = std::make_unique<LoadNode<Number>>();
  node->i = event.i;
  node->j = event.j;
  node->outer = event.kind != Kind::rebound;
  node->members = {model_.members(event.i), model_.members(event.j)};
  node->inverse_mass = {bodies_->inverse_i, bodies_->inverse_j};
  node->speeds = largest(bodies_->v_i) + largest(bodies_->v_j);
  node->recorded = event.dp_stored.has_value();
  if (event.dp_stored) node->dp = *event.dp_stored;
  const Vec<W> added = bodies_->mu * bodies_->v;
  node->dp_exact = expected_.response.dp - added;
  if (!node->recorded) {
    const W of_eq7 = W(6) * model_.precision.u * (length(expected_.response.dp) + length(added)) +
                     bodies_->mu * bodies_->drift();
    node->dp_error = W(expected_.roundings) * expected_.response.error + of_eq7;
    node->speed_error = W(expected_.roundings) * expected_.response.speed_error + of_eq7;
    node->energy_error = expected_.response.lost_by_turning;
  }
  const W zero(0);
  const W joined = bodies_->inverse_i == zero || bodies_->inverse_j == zero
                       ? zero
                       : bodies_->inverse_i * bodies_->inverse_j / (bodies_->inverse_i + bodies_->inverse_j);
  const Number dt = stored<Number>(model_.scene.grouping->dt_restitute, model_.precision);
  model_.groups.load(std::move(node), joined, event.t, later_by(event.t, dt, model_.precision));
}

/// Before the event.
template <typename Number>
Work<Number> Checker<Number>::speeds_of(int i, int j) const {
  return length(widened<W>(model_.flight(i).velocity)) + length(widened<W>(model_.flight(j).velocity));
}

template <typename Number>
void Checker<Number>::follow_restitution(const EventLine<Number>& event) {
  Body<Number>* body = model_.groups.with_root(event.i, event.j);
  if (body == nullptr) {
    for (const InvolvedParticle<Number>& p : event.involved)
      begin_flight(event, p.particle, p.velocity_after);
    return;
  }
  const auto node = model_.groups.part(body);
  const W speeds = speeds_of(event.i, event.j);
  const std::array<int, 2> pair = {event.i, event.j};
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec<Number> velocity = event.of(pair[side])->velocity_after;
    for (const int member : node->members[side]) begin_flight(event, member, velocity);
  }
  model_.note_response(event.i, event.j, node->outer, speeds);
}

/// Takes over what the event says happened, whatever the rules think of it.
template <typename Number>
void Checker<Number>::follow(const EventLine<Number>& event, const std::vector<int>& changed) {
  if (event.k) model_.events = *event.k - 1;
  ++model_.events;
  if (reading(event.t, model_.precision) != reading(model_.now, model_.precision)) {
    model_.progress_event = model_.events - 1;
  }
  ++model_.kinds[static_cast<std::size_t>(event.kind)];
  const bool draws_unsaid =
      minimal_ && event.j >= 0 && is_collision(event.kind) && detail::is_matter_of_chance(model_, event);
  if (event.draw || draws_unsaid) ++model_.draws[detail::draw_key(model_, event)];
  const Context<Number>& c = context_;
  const bool both_fixed = event.j >= 0 && model_.fixed(event.i) && model_.fixed(event.j);
  const bool loads = bodies_ && !both_fixed && is_collision(event.kind) && is_load(c, event, expected_) &&
                     !model_.groups.together(event.i, event.j);
  const W speeds = event.j >= 0 ? speeds_of(event.i, event.j) : W(0);
  if (event.kind == Kind::restitute) {
    follow_restitution(event);
  } else {
    if (loads) follow_load(event);
    for (const InvolvedParticle<Number>& p : event.involved)
      begin_flight(event, p.particle, p.velocity_after);
  }
  for (const InvolvedParticle<Number>& p : event.involved) {
    if (!model_.spins.empty() && p.spin_after) model_.spins[Model<Number>::at(p.particle)] = *p.spin_after;
  }
  if (event.formed && *event.formed) {
    model_.tethers[static_cast<std::size_t>(event.i)].insert(event.j);
    model_.tethers[static_cast<std::size_t>(event.j)].insert(event.i);
  }
  if (event.kind == Kind::broken) {
    model_.tethers[static_cast<std::size_t>(event.i)].erase(event.j);
    model_.tethers[static_cast<std::size_t>(event.j)].erase(event.i);
  } else if (is_collision(event.kind) && !model_.groups.together(event.i, event.j)) {
    model_.note_response(event.i, event.j, event.kind != Kind::rebound, speeds);
  }
  if (EffectRules<Number>* effect = model_.effect_of(event.kind)) {
    effect->follow(context_, event,
                   [&](int i, const Vec<Number>& velocity) { follow_unsaid(event, i, velocity); });
    if (effect->next(context_)) effect->pass(context_);
  }
  model_.now = event.t;
  for (const int i : changed) {
    if (model_.fixed(i)) continue;
    waits_.changed_at[Model<Number>::at(i)] = waits_.step;
    told_[Model<Number>::at(i)].clear();
    for (const int whose : with_agenda_) agendas_[Model<Number>::at(whose)]->begins_flight(i);
    place(i, event.t);
  }
}

}  // namespace tps::check
