// A model from a full state: what the check knows of a run that it takes up there.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/state_values.hpp"

namespace tps::check {

/// What of a model its full state does not hold: bodies have the speeds before their loads.
template <typename Number>
bool is_whole_in_state(const Context<Number>& c) {
  return c.model.groups.size() == 0 && std::ranges::all_of(c.model.effects, [&](const auto& effect) {
           return effect->is_whole_in_state(c);
         });
}

/// Puts a model that is at the start of its scene where a full state is. Of pairs that have responded the
/// speeds before that are not known; those after it stand for them. REQUIRES no bodies in the state. Throws
/// std::exception where it is no state of the scene.
template <typename Number>
void restore(const Context<Number>& c, const StateData& state) {
  Model<Number>& model = c.model;
  const auto at = [](int n) { return Model<Number>::at(n); };
  if (!state.groups.empty()) throw std::runtime_error("bodies are not taken up");
  std::unordered_map<std::int32_t, int> index_of;
  for (int i = 0; i < model.size(); ++i) index_of.emplace(model.id(i), i);
  model.events = state.k;
  model.now = model.asked = instant_in_state<Number>(state.last_event);
  model.progress_event = state.progress_event;
  for (const StateData::Particle& p : state.particles) {
    const int i = index_of.at(p.id);
    model.set_flight(i, vector_in_state<Number>(p.position, model.scene.dimension),
                     vector_in_state<Number>(p.velocity, model.scene.dimension),
                     instant_in_state<Number>(p.clock), Work<Number>(0));
    if (model.keeps_spin(i)) model.spins[at(i)] = spin_in_state<Number>(p.spin);
  }
  std::fill(model.tethers.begin(), model.tethers.end(), std::set<int>());
  for (const auto& [first, second] : state.tethers) {
    model.tethers[at(index_of.at(first))].insert(index_of.at(second));
    model.tethers[at(index_of.at(second))].insert(index_of.at(first));
  }
  for (const StateData::Responded& r : state.responded) {
    const int i = index_of.at(r.first), j = index_of.at(r.second);
    model.note_response(i, j, r.outer,
                        length(widened<Work<Number>>(model.flight(i).velocity)) +
                            length(widened<Work<Number>>(model.flight(j).velocity)));
  }
  for (const StateData::Draws& d : state.draws) model.draws[{d.purpose, d.first, d.second}] = d.used;
  for (const KindRow& known : kinds()) {
    const auto found = state.counts.find(known.name);
    const std::uint64_t count = found == state.counts.end() ? 0 : found->second;
    if (count > state.k) throw std::out_of_range("more events of a kind than events");
    model.kinds[static_cast<std::size_t>(known.kind)] = count;
  }
  for (const auto& effect : model.effects) effect->pass_over(c, effect->events_in(c, state));
}

}  // namespace tps::check
