// What the check knows of one effect that acts at times known in advance: a file an effect in effects/. Rules
// of pairs, groups and walls are the check's own (rules/).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "verify/trace_check/line.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

template <typename Number>
struct Context;

/// An event that an effect has ahead.
struct EventAhead {
  double at;                 ///< since the start
  int particle = -1;         ///< −1: not one's
  std::uint32_t number = 0;  ///< of the particle's own, where times are random
};

/// Follows one effect through a trace. One is made for every scene, whether it calls for the effect or not.
template <typename Number>
class EffectRules {
 public:
  using BeginFlight = std::function<void(int particle, const Vec<Number>& velocity)>;

  virtual ~EffectRules() = default;
  /// As the engine's effect is called, in states, too.
  virtual std::string_view effect() const = 0;
  /// Of its events among others at one time: docs/semantics.md §6.
  virtual int rank() const = 0;
  /// What is ahead, in sentences: "phase change".
  virtual std::string what() const = 0;

  /// Its next event; nothing where there is none, or where a generator other than ours decides.
  virtual std::optional<EventAhead> next(const Context<Number>&) const = 0;
  /// The next one is past: it has happened, or another event came although it was due. REQUIRES that there is
  /// one.
  virtual void pass(const Context<Number>&) = 0;
  /// Judges one of its events, before anything of it is taken over.
  virtual void judge(const Context<Number>&, const EventLine<Number>&) const = 0;
  /// Takes over what follow() of Checker does not: other flights than those of the particles listed, counts.
  virtual void follow(const Context<Number>&, const EventLine<Number>&, const BeginFlight&) {}

  /// Whether its events begin flights of all particles.
  virtual bool moves_everybody() const { return false; }
  /// What waits from its last event on: each particle's next one, or (−1) that of the effect.
  virtual int waits_for(const EventLine<Number>&) const { return -1; }
  /// Its events so far where states count them, else 0.
  virtual std::uint64_t progress() const { return 0; }

  /// How many of its events have passed by a full state.
  virtual std::uint64_t events_in(const Context<Number>&, const StateData& state) const {
    const auto found = state.progress.find(std::string(effect()));
    return found == state.progress.end() ? 0 : found->second;
  }
  /// So many of its events are past. Throws std::out_of_range where the scene has fewer.
  virtual void pass_over(const Context<Number>& c, std::uint64_t count) {
    for (; count > 0; --count) {
      if (!next(c)) throw std::out_of_range("the scene has fewer events of " + std::string(effect()));
      pass(c);
    }
  }
  /// Whether so many of its events were passed over at once that the rest is not waited for.
  bool given_up = false;

  /// Whether pass_over(events_in) gets from the start to where it is.
  virtual bool is_whole_in_state(const Context<Number>&) const { return true; }
};

template <typename Number>
using EffectRulesMaker = std::unique_ptr<EffectRules<Number>> (*)(const Scene&);

/// Of effects that a program brings along (reference/engine/brought_effect.hpp).
template <typename Number>
std::vector<EffectRulesMaker<Number>>& brought_rules() {
  static std::vector<EffectRulesMaker<Number>> makers;
  return makers;
}

/// `const BringRules<effects::turns, double> kRules;` at namespace scope; traces of wider scalars have Wide.
template <typename Rules, typename... Numbers>
class BringRules {
 public:
  BringRules() { (brought_rules<Numbers>().push_back(&Rules::template make<Numbers>), ...); }
};

}  // namespace tps::check
