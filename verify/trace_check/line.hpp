// Lines of a trace as the check sees them: particles are places in the scene, numbers are exact.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "reference/trace/state_data.hpp"
#include "verify/trace_check/kinds.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

template <typename Number>
struct InvolvedParticle {
  int particle;  ///< index into the scene
  std::optional<Vec<Number>> position_before, velocity_before, position_after;
  Vec<Number> velocity_after;
  std::optional<Vec<Number>> spin_before = {}, spin_after = {};  ///< in the plane along z
};

/// Of an effect's own: a whole number, a word, or numbers.
template <typename Number>
struct OwnValue {
  std::string key;
  std::variant<std::int64_t, std::string, std::vector<Number>> value;
};

template <typename Number>
struct EventLine {
  std::optional<std::uint64_t> k;
  Instant<Number> t;  ///< of the run's clock: under drag s
  std::string t_text;
  std::optional<double> time;  ///< under drag: the time that is printed beside s
  std::optional<Number> dt;
  Kind kind{};
  int i = -1, j = -1;
  std::optional<int> phase;
  std::optional<int> wall, face;  ///< which a particle met
  std::vector<InvolvedParticle<Number>> involved;
  std::optional<Vec<Number>> dp, dp_stored, dv;
  std::optional<bool> sticks;  ///< where friction acted
  std::optional<bool> formed;  ///< true: a tether formed, false: it broke
  std::optional<double> draw;
  std::vector<int> members;
  std::vector<OwnValue<Number>> own;

  const std::variant<std::int64_t, std::string, std::vector<Number>>* value_of(std::string_view key) const {
    for (const OwnValue<Number>& value : own) {
      if (value.key == key) return &value.value;
    }
    return nullptr;
  }
  /// Nothing is said; the memory of lists is kept.
  void restart() {
    EventLine fresh;
    std::swap(fresh.t_text, t_text);
    std::swap(fresh.involved, involved);
    std::swap(fresh.members, members);
    std::swap(fresh.places_, places_);
    fresh.t_text.clear();
    fresh.involved.clear();
    fresh.places_.clear();
    fresh.members.clear();
    *this = std::move(fresh);
  }

  /// To be called when `involved` is complete: the members of a large body are found by bisection from then
  /// on.
  /// @return whether each particle stands there once.
  bool index_involved() {
    places_.clear();
    if (involved.size() <= kFew) {
      for (const auto& p : involved) {
        if (of(p.particle) != &p) return false;
      }
      return true;
    }
    for (std::size_t n = 0; n < involved.size(); ++n) places_.emplace_back(involved[n].particle, n);
    std::sort(places_.begin(), places_.end());
    return std::adjacent_find(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
             return a.first == b.first;
           }) == places_.end();
  }

  const InvolvedParticle<Number>* of(int particle) const {
    const std::size_t n = place_of(particle);
    return n < involved.size() ? &involved[n] : nullptr;
  }
  InvolvedParticle<Number>* of(int particle) {
    const std::size_t n = place_of(particle);
    return n < involved.size() ? &involved[n] : nullptr;
  }

 private:
  using Place = std::pair<int, std::size_t>;  ///< a particle, and where it stands in `involved`
  static constexpr std::size_t kFew = 8;

  /// involved.size() where there is none.
  std::size_t place_of(int particle) const {
    if (places_.empty()) {
      std::size_t n = 0;
      while (n < involved.size() && involved[n].particle != particle) ++n;
      return n;
    }
    const auto found = std::lower_bound(places_.begin(), places_.end(), Place{particle, 0});
    return found != places_.end() && found->first == particle ? found->second : involved.size();
  }

  std::vector<Place> places_;  ///< ascending; empty where few are involved
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
  std::optional<double> time;  ///< under drag, of the last event or state
  std::optional<Instant<Number>>
      duration;  ///< under drag, of a run that ends by its duration: since the start
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
/// The same of a line that says the end.
class EndProblem : public LineProblem {
 public:
  explicit EndProblem(const LineProblem& problem) : LineProblem(problem) {}
};

}  // namespace tps::check
