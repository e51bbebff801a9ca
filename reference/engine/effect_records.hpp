// What an effect leaves in a trace: kinds of events, and what of it a full state holds. Writer, reader and
// check know effects by this alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/scene/random.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// Whom an event is about.
enum class About : std::uint8_t { pair, particle, everybody, rules };

/// A kind of event.
struct EventKind {
  std::string_view name;  ///< in traces
  About about;
  std::vector<std::string_view> own_keys = {};  ///< which every line of this kind has beside those of all
};

struct EffectRecords {
  /// How many events known in advance a state can say to have happened, and what more of them would be.
  struct Known {
    std::uint64_t most;
    std::string too_many;  ///< "is more than the impulses of the scene"
  };
  /// A stream of random numbers a particle, counted in states.
  struct Draws {
    Purpose purpose;
    bool (*draws)(const Scene&, const Particle&);
  };

  /// A list of Effect::numbers(): by default a sum in two parts.
  struct Quantity {
    std::string name;
    std::size_t size = 2;
  };

  std::vector<EventKind> kinds = {};
  std::optional<Known> known = {};  ///< of an effect with Effect::progress()
  std::vector<Quantity> quantities = {};
  std::optional<Draws> draws = {};
};

}  // namespace tps
