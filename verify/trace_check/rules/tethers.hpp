// Rule tethers: tethers form and break by the rules of their pair.
#pragma once

#include "reference/scene/random.hpp"
#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/impulse.hpp"

namespace tps::check {
namespace detail {

template <typename Number>
bool has_room(const Model<Number>& model, int i) {
  const Particle& p = model.scene.particles[static_cast<std::size_t>(i)];
  const auto& capacity = model.scene.species[static_cast<std::size_t>(p.species)].max_tethers;
  return !capacity || model.tethers[static_cast<std::size_t>(i)].size() < static_cast<std::size_t>(*capacity);
}

/// Whether a rebound may form a tether, by the rule of a pair that has none yet.
template <typename Number>
bool may_form(const Model<Number>& model, const EventLine<Number>& event) {
  const PairRules<Number>& rules = model.rules.of(event.i, event.j);
  return rules.can_tether && !rules.permanent && rules.form.when != FormRule::When::never;
}

template <typename Number>
bool is_untethered(const Model<Number>& model, const EventLine<Number>& event) {
  return model.tethers[static_cast<std::size_t>(event.i)].count(event.j) == 0;
}

/// Whether a probability decides about the tether of the pair.
template <typename Number>
bool is_matter_of_chance(const Model<Number>& model, const EventLine<Number>& event) {
  const PairRules<Number>& rules = model.rules.of(event.i, event.j);
  if (event.kind != Kind::rebound) return rules.breaks.when == BreakRule::When::probability;
  return rules.form.when == FormRule::When::probability && may_form(model, event) &&
         is_untethered(model, event) && has_room(model, event.i) && has_room(model, event.j);
}

/// What a draw at an event is for, and whose it is: under this key the model counts those that are used.
template <typename Number>
std::array<int, 3> draw_key(const Model<Number>& model, const EventLine<Number>& event) {
  const Purpose purpose = event.kind == Kind::rebound ? Purpose::tether_form : Purpose::tether_break;
  return {static_cast<int>(purpose), model.id(event.i), model.id(event.j)};
}

/// The draw of our generator for the scene's seed, for what it is for (docs/decisions.md, N12).
struct SeedsDraw {
  std::uint32_t used;  ///< draws for it so far
  double value;
};

template <typename Number>
SeedsDraw draw_of_seed(const Model<Number>& model, const EventLine<Number>& event) {
  const std::array<int, 3> key = draw_key(model, event);
  const auto before = model.draws.find(key);
  const std::uint32_t used = before == model.draws.end() ? 0 : before->second;
  const auto& [purpose, i, j] = key;
  return {used, uniform(model.scene.seed, static_cast<Purpose>(purpose), static_cast<std::uint32_t>(i),
                        static_cast<std::uint32_t>(j), used)};
}

/// A draw that is recorded, unless it is taken as given.
template <typename Number>
void judge_draw(const Context<Number>& c, const EventLine<Number>& event) {
  if (!c.own_draws) return;
  const auto [used, right] = draw_of_seed(c.model, event);
  c.tally.demand(Rule::tethers, *event.draw == right, [&, used = used, right = right](Finding& f) {
    const auto [found, expected] = told_apart(*event.draw, right);
    f.message = fmt::format(
        "the draw of {} is {}; draw {} of seed {} for it is {} (--trust-draws takes draws as given)",
        c.pair(event.i, event.j), found, used, c.model.scene.seed, expected);
  });
}

/// What a probability decides where no draw is recorded, which a minimal trace may leave out.
template <typename Number>
std::optional<bool> decision_without_record(const Context<Number>& c, const EventLine<Number>& event,
                                            double probability) {
  if (c.own_draws) return draw_of_seed(c.model, event).value < probability;
  if (probability <= 0 || probability >= 1) return probability >= 1;
  c.tally.not_judged(Rule::tethers, "what a probability decides is taken as given where no draw is recorded");
  return std::nullopt;
}

template <typename Number>
std::string chance_in_words(const Context<Number>& c, const EventLine<Number>& event, double probability) {
  if (!event.draw && !c.own_draws) return fmt::format("the probability is {}", probability);
  return fmt::format("the draw is {} and the probability {}",
                     event.draw ? *event.draw : draw_of_seed(c.model, event).value, probability);
}

/// A random number is drawn exactly where a probability decides. @return whether it says yes.
template <typename Number>
std::optional<bool> decision(const Context<Number>& c, const EventLine<Number>& event, bool asked,
                             double probability, const char* what) {
  if (c.minimal && asked && !event.draw) return decision_without_record(c, event, probability);
  c.tally.demand(Rule::tethers, asked == event.draw.has_value(), [&](Finding& f) {
    f.message =
        asked ? fmt::format(
                    "whether the tether of {} {} is a matter of probability {}, but no draw is recorded",
                    c.pair(event.i, event.j), what, probability)
              : fmt::format("a draw is recorded, but nothing about the tether of {} is left to chance",
                            c.pair(event.i, event.j));
  });
  if (!asked || !event.draw) return std::nullopt;
  judge_draw(c, event);
  return *event.draw < probability;
}

}  // namespace detail

/// A tether forms at a rebound of an untethered pair, by the pair's rule, unless one of the two is full.
template <typename Number>
void judge_forming(const Context<Number>& c, const EventLine<Number>& event) {
  const Model<Number>& model = c.model;
  const PairRules<Number>& rules = model.rules.of(event.i, event.j);
  const bool forms = event.formed.value_or(false);
  const bool can = detail::may_form(model, event);
  const bool free = can && detail::is_untethered(model, event);
  const bool room = detail::has_room(model, event.i) && detail::has_room(model, event.j);
  const bool chance = detail::is_matter_of_chance(model, event);
  const std::optional<bool> drawn = detail::decision(c, event, chance, rules.form.probability, "forms");
  if (chance && !drawn) return;
  const bool should = free && room && drawn.value_or(true);
  c.tally.demand(Rule::tethers, forms == should, [&](Finding& f) {
    const std::string why = !can     ? "their rule never forms one"
                            : !free  ? "they are tethered already"
                            : !room  ? "one of them has all the tethers it can have"
                            : chance ? detail::chance_in_words(c, event, rules.form.probability)
                                     : "their rule always forms one";
    f.message =
        fmt::format("{} {} a tether, but {}", c.pair(event.i, event.j), forms ? "form" : "do not form", why);
  });
}

/// A tether breaks at a tethering collision of a tethered pair, by the pair's rule.
template <typename Number>
void judge_breaking(const Context<Number>& c, const EventLine<Number>& event,
                    const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const PairRules<Number>& rules = model.rules.of(event.i, event.j);
  c.tally.demand(Rule::tethers, model.tethered(event.i, event.j), [&](Finding& f) {
    f.message = fmt::format("{} {}, but they are not tethered", c.pair(event.i, event.j), name(event.kind));
  });
  const bool breaks = event.kind == Kind::broken;
  using When = BreakRule::When;
  const std::optional<bool> drawn =
      detail::decision(c, event, rules.breaks.when == When::probability, rules.breaks.probability, "breaks");
  if (rules.breaks.when == When::probability && !drawn) return;
  bool should = rules.breaks.when == When::always || drawn.value_or(false);
  // Under drag Δp is e^{γt} times a momentum of the scene; e^{−γt} = 1 − γs has two roundings, and the
  // product one.
  const bool drag = model.scene.drag.has_value();
  const W left =
      drag ? W(1) - W(stored<Number>(model.scene.drag->gamma, model.precision)) * W(event.t.hi) : W(1);
  const W size = length(expected.response.dp) * left;
  if (rules.breaks.when == When::impulse_above) {
    const W of_drag = drag ? W(4) * c.u() * length(expected.response.dp) : W(0);
    const W unit = (W(expected.roundings + 4) * expected.response.error * left + of_drag) * c.scale() +
                   model.precision.smallest;
    const W beyond = size - W(stored<Number>(rules.breaks.threshold, model.precision));
    should = beyond > W(0);
    if (beyond <= unit && beyond >= -unit) should = breaks;
  }
  c.tally.demand(Rule::tethers, breaks == should, [&](Finding& f) {
    const auto told = told_apart(size, W(stored<Number>(rules.breaks.threshold, model.precision)));
    f.message = fmt::format("the tether of {} {}, but by its rule it {}{}", c.pair(event.i, event.j),
                            breaks ? "breaks" : "holds", should ? "breaks" : "holds",
                            rules.breaks.when == When::impulse_above
                                ? fmt::format(": |Δp| = {} and the threshold is {}", told.first, told.second)
                            : drawn ? ": " + detail::chance_in_words(c, event, rules.breaks.probability)
                                    : std::string());
  });
}

}  // namespace tps::check
