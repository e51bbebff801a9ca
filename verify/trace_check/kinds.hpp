// The kinds of events, a row each: whom a line of the kind is about, what it has of its own, and whose turn
// it is at one time. Another kind is another row; no other list of kinds stands in the check.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

namespace tps::check {

enum class Kind : std::uint8_t {
  rebound,
  retract,
  revolve,
  broken,
  restitute,
  wall,
  scheduled_impulse,
  random_impulse,
  thermostat,
  gravity,
  phase_begin,
  phase_end,
};

/// Whom an event is about.
enum class About : std::uint8_t { pair, particle, everybody, rules };

struct KindRow {
  Kind kind;
  std::string_view name;  ///< in traces
  About about;
  int rank;                  ///< order at one time (docs/decisions.md, D13)
  bool collides;             ///< a pair at one of its limits: it may have a draw
  bool responds;             ///< with Δp of eq. (4) or (5), which a group may keep
  bool from_outside;         ///< at a time that is known in advance
  std::string_view own_key;  ///< which a line of this kind has and no other one
};

inline constexpr KindRow kKinds[] = {
    {Kind::rebound, "rebound", About::pair, 7, true, true, false, ""},
    {Kind::retract, "retract", About::pair, 7, true, true, false, ""},
    {Kind::revolve, "revolve", About::pair, 7, true, true, false, ""},
    {Kind::broken, "break", About::pair, 7, true, false, false, ""},
    {Kind::restitute, "restitute", About::pair, 0, false, false, false, ""},
    {Kind::wall, "wall", About::particle, 6, false, false, false, "wall"},
    {Kind::scheduled_impulse, "scheduled_impulse", About::particle, 2, false, false, true, ""},
    {Kind::random_impulse, "random_impulse", About::particle, 4, false, false, true, ""},
    {Kind::thermostat, "thermostat", About::particle, 5, false, false, true, ""},
    {Kind::gravity, "gravity", About::everybody, 3, false, false, true, "dv"},
    {Kind::phase_begin, "phase_begin", About::rules, 1, false, false, false, "phase"},
    {Kind::phase_end, "phase_end", About::rules, 1, false, false, false, "phase"},
};
static_assert(std::ranges::is_sorted(kKinds, {}, &KindRow::kind) &&
              static_cast<std::size_t>(std::rbegin(kKinds)->kind) + 1 == std::size(kKinds));

constexpr const KindRow& row(Kind kind) {
  return kKinds[static_cast<std::size_t>(kind)];
}
constexpr std::string_view name(Kind kind) {
  return row(kind).name;
}
constexpr int rank(Kind kind) {
  return row(kind).rank;
}
constexpr bool is_collision(Kind kind) {
  return row(kind).collides;
}
/// What comes from outside at a time that is known in advance.
constexpr bool is_outside(Kind kind) {
  return row(kind).from_outside;
}
/// An impulse from outside on one particle.
constexpr bool is_kick(Kind kind) {
  return is_outside(kind) && row(kind).about == About::particle;
}
constexpr bool is_phase(Kind kind) {
  return row(kind).about == About::rules;
}
/// The name for sentences: "scheduled impulse".
inline std::string words(Kind kind) {
  std::string text(name(kind));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace tps::check
