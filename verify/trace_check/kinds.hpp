// The kinds of events, a row each: whom a line of the kind is about and what it has of its own. Those of
// pairs and walls, which the check judges itself, have names here; those of other effects are numbered behind
// them, from what the effects say (reference/engine/effect_facts.hpp). No other list of kinds stands in the
// check.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/effect_records.hpp"

namespace tps::check {

enum class Kind : std::uint8_t { rebound, retract, revolve, broken, restitute, wall };

struct KindRow {
  Kind kind;
  std::string name;    ///< in traces
  std::string effect;  ///< that records it
  About about;
  bool collides;                           ///< a pair at one of its limits: it may have a draw
  bool responds;                           ///< with Δp of eq. (4) or (5), which a group may keep
  std::vector<std::string_view> own_keys;  ///< which a line of this kind has and no other one

  bool owns(std::string_view key) const;
};

/// kinds()[n] is that of Kind(n).
const std::vector<KindRow>& kinds();

inline const KindRow& row(Kind kind) {
  return kinds()[static_cast<std::size_t>(kind)];
}
inline const std::string& name(Kind kind) {
  return row(kind).name;
}
constexpr bool is_collision(Kind kind) {
  return kind < Kind::restitute;
}
/// What an effect's own rules judge.
constexpr bool is_of_effect(Kind kind) {
  return kind > Kind::wall;
}
/// An event that an effect has on one particle.
inline bool is_kick(Kind kind) {
  return is_of_effect(kind) && row(kind).about == About::particle;
}
/// The name for sentences: "scheduled impulse".
std::string words(Kind kind);

/// Who comes first at one time (docs/decisions.md, D13); effects say their own, between the first two.
inline constexpr int kRankOfRestitution = 0, kRankAtWall = 60, kRankOfPair = 70;

}  // namespace tps::check
