// The rules of the trace check: what each demands, where it is explained.
#pragma once

#include <array>
#include <string_view>

namespace tps::check {

enum class Rule {
  schema,
  order,
  flight,
  bystanders,
  contact,
  impulse,
  conservation,
  earliest,
  bounds,
  tethers,
  groups,
  states,
  progress,
  end,
  bias,
};

constexpr std::size_t kRules = 15;

struct RuleFacts {
  Rule rule;
  std::string_view name;
  std::string_view sentence;  ///< what it demands
};

/// In the order of the reports. The page of a rule is docs/check.md, section `name`.
constexpr std::array<RuleFacts, kRules> kRuleFacts{{
    {Rule::schema, "schema", "every line is well formed and has what its kind needs"},
    {Rule::order, "order",
     "events are counted from 1 and come in their turns, time never goes back, dt is the difference of two "
     "times"},
    {Rule::flight, "flight", "between events a particle flies straight: u + v dt"},
    {Rule::bystanders, "bystanders", "what is not involved does not change"},
    {Rule::contact, "contact", "at its event a pair is at its limit and moves the right way, eqs. 1-2"},
    {Rule::impulse, "impulse", "impulses and velocities after are those of eqs. 3-7"},
    {Rule::conservation, "conservation", "momentum, energy and angular momentum balance at every event"},
    {Rule::earliest, "earliest", "nothing else was due before"},
    {Rule::bounds, "bounds", "no pair passes its inner or outer limit in flight"},
    {Rule::tethers, "tethers", "tethers form and break by the rules of their pair"},
    {Rule::groups, "groups", "bodies load, expire and part as their tree says"},
    {Rule::states, "states", "a full state is what the events made"},
    {Rule::progress, "progress", "a run that stands still is called stalled, and no other"},
    {Rule::end, "end", "the last line is there and says what happened"},
    {Rule::bias, "bias", "residuals have no sign of their own over the whole run"},
}};

constexpr std::string_view name(Rule rule) {
  return kRuleFacts[static_cast<std::size_t>(rule)].name;
}

}  // namespace tps::check
