// Lines of a trace as the check sees them: particles are places in the scene, numbers are exact.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "reference/trace/state_data.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

enum class Kind {
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

/// As traces call them, in the order of the enumerators.
constexpr std::string_view kKindNames[] = {"rebound",    "retract", "revolve",           "break",
                                           "restitute",  "wall",    "scheduled_impulse", "random_impulse",
                                           "thermostat", "gravity", "phase_begin",       "phase_end"};

constexpr std::string_view name(Kind kind) {
  return kKindNames[static_cast<int>(kind)];
}
constexpr bool is_collision(Kind kind) {
  return kind <= Kind::broken;
}
/// The same for sentences: "scheduled impulse".
inline std::string words(Kind kind) {
  std::string text(name(kind));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}
/// An impulse from outside on one particle.
constexpr bool is_kick(Kind kind) {
  return kind >= Kind::scheduled_impulse && kind <= Kind::thermostat;
}
/// What comes from outside at a time that is known in advance.
constexpr bool is_outside(Kind kind) {
  return is_kick(kind) || kind == Kind::gravity;
}
constexpr bool is_phase(Kind kind) {
  return kind >= Kind::phase_begin;
}

template <typename Number>
struct InvolvedParticle {
  int particle;  ///< index into the scene
  std::optional<Vec<Number>> position_before, velocity_before, position_after;
  Vec<Number> velocity_after;
};

template <typename Number>
struct EventLine {
  std::optional<std::uint64_t> k;
  Instant<Number> t;  ///< of the run's clock: under drag s
  std::string t_text;
  std::optional<double> time;  ///< under drag: the time that is printed beside s
  std::optional<Number> dt;
  Kind kind;
  int i = -1, j = -1;
  std::optional<int> phase;
  std::optional<int> wall, face;  ///< which a particle met
  std::vector<InvolvedParticle<Number>> involved;
  std::optional<Vec<Number>> dp, dp_stored, dv;
  std::optional<bool> formed;  ///< true: a tether formed, false: it broke
  std::optional<double> draw;
  std::vector<int> members;

  const InvolvedParticle<Number>* of(int particle) const { return find(involved, particle); }
  InvolvedParticle<Number>* of(int particle) { return find(involved, particle); }

 private:
  template <typename Particles>
  static auto find(Particles& particles, int particle) -> decltype(particles.data()) {
    for (auto& p : particles) {
      if (p.particle == particle) return &p;
    }
    return nullptr;
  }
};

template <typename Number>
struct StateLine {
  StateData data;
  Instant<Number> t;           ///< of the run's clock: under drag "now"
  std::optional<double> time;  ///< under drag
};

template <typename Number>
struct EndLine {
  std::string reason;
  std::uint64_t events;
  Instant<Number> t;           ///< of the run's clock
  std::optional<double> time;  ///< under drag
};

template <typename Number>
using Line = std::variant<EventLine<Number>, StateLine<Number>, EndLine<Number>>;

/// A line that is not what a trace has: where in it, and what is the matter.
class LineProblem : public std::runtime_error {
 public:
  LineProblem(std::string pointer_in, const std::string& message)
      : std::runtime_error(message), pointer(std::move(pointer_in)) {}
  std::string pointer;
};

}  // namespace tps::check
