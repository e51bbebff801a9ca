#include "verify/import/arslab_tps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "reference/scene/check_starts.hpp"
#include "reference/scene/scene_source.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/schema_validator.hpp"
#include "reference/text/schema_words.hpp"

namespace tps::arslab {
namespace {

constexpr double built_in_runtime = 25;  // of that program, where its file has no "runtime"

/// The id that a key spells in the one way that has no other spelling.
std::optional<std::int32_t> particle_id(std::string_view key) {
  std::int32_t id = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), id);
  const bool spelt = error == std::errc() && end == key.data() + key.size();
  return spelt && std::to_string(id) == key && id >= 0 ? std::optional(id) : std::nullopt;
}

// Readers of values whose shape the schema has accepted.

double number(const JsonValue& object, std::string_view key) {
  return object.find(key)->number()->value;
}

const JsonValue::Object& members(const JsonValue& root, std::string_view key) {
  static const JsonValue::Object none;
  const JsonValue* value = root.find(key);
  return value == nullptr || value->object() == nullptr ? none : *value->object();
}

class Importer {
 public:
  Importer(const JsonValue& root, InputProblems& problems, const ImportOptions& options)
      : root_(root), options_(options), source_(root, "", problems) {
    for (const JsonMember& member : members(root, "species")) names_.push_back(member.key);
  }

  ImportedScene read() {
    if (source_.full() || has_too_many_species()) return {};
    scene_.title = "Imported from a scenario of ARSLab_TPS";
    if (options_.dt_restitute) scene_.grouping = Grouping{*options_.dt_restitute};
    if (there("config")) {
      read_config(*root_.find("config"));
    } else if (root_.find("config") == nullptr) {
      with_impulses_ = !options_.without_random_impulses;
      scene_.duration = options_.duration.value_or(built_in_runtime);
      if (!options_.duration) note_built_in_runtime("config");
    }
    if (there("species")) read_species();
    if (there("species")) add_blocking_laws();
    read_particles();
    if (there("species") && there("particles")) check_starts(scene_, source_);
    return {std::move(scene_), std::move(notes_)};
  }

 private:
  bool there(std::string_view key) const { return root_.find(key) != nullptr && source_.sound({key}); }

  void read_config(const JsonValue& config) {
    const bool random_impulses = *config.find("ri")->boolean();
    with_impulses_ = random_impulses && !options_.without_random_impulses;
    if (random_impulses && !with_impulses_)
      notes_.push_back("config.ri is true; the scene has no random impulses, as asked");
    const JsonValue* runtime = config.find("runtime");
    if (runtime == nullptr && !options_.duration) note_built_in_runtime("config.runtime");
    scene_.duration =
        options_.duration.value_or(runtime == nullptr ? built_in_runtime : runtime->number()->value);
  }

  void note_built_in_runtime(std::string_view missing) {
    notes_.push_back(
        fmt::format("{} is missing; the duration is {}, the built-in time of ARSLab_TPS for such files; "
                    "--duration gives another",
                    missing, built_in_runtime));
  }

  /// tau, shape and mean of a species, where the file asks for random impulses. Files of the first versions
  /// have no config: whatever species described them had them.
  std::optional<RandomImpulses> read_impulses(const JsonMember& species) {
    const auto given = [&](const char* key) { return species.value.find(key) != nullptr; };
    if (!with_impulses_ || !(given("tau") || given("shape") || given("mean"))) return std::nullopt;
    RandomImpulses impulses;
    for (const auto& [key, value] : {std::pair("tau", &impulses.tau), std::pair("shape", &impulses.shape),
                                     std::pair("mean", &impulses.mean)}) {
      const std::string at = "/species/" + escape_pointer_key(species.key);
      if (!given(key)) {
        source_.report(at, fmt::format("lacks {}; random impulses have tau, shape and mean; add it, or give "
                                       "--without-random-impulses",
                                       key));
        continue;
      }
      *value = number(species.value, key);
      if (!(*value > 0))
        source_.report(at + "/" + key,
                       fmt::format("is {}; allowed: above 0, or give --without-random-impulses",
                                   write_shortest(*value)));
    }
    return impulses;
  }

  bool has_too_many_species() {
    if (names_.size() <= max_species) return false;
    source_.report("/species", fmt::format("found {} species; allowed: at most {}, since every two of them "
                                           "interact; remove those without particles",
                                           names_.size(), max_species));
    return true;
  }

  void read_species() {
    bool has_impulse_keys = false;
    for (const JsonMember& member : members(root_, "species")) {
      if (member.key.size() > max_species_name) {
        source_.report("/species/" + escape_pointer_key(member.key),
                       fmt::format("the name has {} bytes; allowed: at most {}; give it a shorter one",
                                   member.key.size(), max_species_name));
      }
      scene_.species.push_back({.name = member.key,
                                .mass = number(member.value, "mass"),
                                .radius = number(member.value, "radius"),
                                .max_tethers = {},
                                .random_impulses = read_impulses(member),
                                .thermostat = {}});
      for (const char* key : {"tau", "shape", "mean"}) has_impulse_keys |= member.value.find(key) != nullptr;
    }
    if (has_impulse_keys && with_impulses_) {
      notes_.push_back(
          "tau, shape and mean are taken as mean waiting time, and shape and mean of the magnitude, of "
          "random "
          "impulses; the draws are our generator's; --without-random-impulses drops them");
    } else if (has_impulse_keys) {
      notes_.push_back("tau, shape and mean of the species are dropped: they describe random impulses");
    }
  }

  void add_blocking_laws() {
    const int count = static_cast<int>(scene_.species.size());
    std::vector<std::string> points;
    for (int a = 0; a < count; ++a) {
      for (int b = a; b < count; ++b) {
        const Species& first = scene_.species[static_cast<std::size_t>(a)];
        const Species& second = scene_.species[static_cast<std::size_t>(b)];
        const double distance = first.radius + second.radius;  // one addition: correctly rounded
        if (distance == 0) {
          if (a == b) points.push_back(first.name);
        } else if (!std::isfinite(distance)) {
          source_.report("/species/" + escape_pointer_key(second.name) + "/radius",
                         fmt::format("the sum of the radii of {} and {} is inf; a blocking distance must be "
                                     "finite: make one of the radii smaller",
                                     in_quotes(first.name), in_quotes(second.name)));
        } else {
          scene_.pairs.push_back(
              {.species_a = a,
               .species_b = b,
               .blocking = BlockingLaw{.distance = distance, .c_rebound = options_.c_rebound.value_or(1)},
               .tethering = {}});
        }
      }
    }
    if (!options_.c_rebound) {
      notes_.push_back(
          "the file has no coefficient of restitution; every pair has c_rebound 1; --c-rebound gives "
          "another");
    }
    if (!points.empty()) {
      notes_.push_back(fmt::format("radius 0: particles of {} do not collide with one another",
                                   quoted_list(points, " and ")));
    }
  }

  void read_particles() {
    const JsonValue::Object& list = members(root_, "particles");
    if (list.empty() && there("particles")) {
      source_.report("/particles",
                     "found no particle, and so no dimension; allowed: at least one; add those that are to "
                     "be simulated");
    }
    for (const JsonMember& member : list) {
      if (source_.full()) return;
      read_particle(member);
    }
    std::sort(scene_.particles.begin(), scene_.particles.end(),
              [](const Particle& a, const Particle& b) { return a.id < b.id; });
    for (const Particle& particle : scene_.particles) {
      source_.particle_entries.push_back(static_cast<std::size_t>(particle.id));
    }
  }

  void read_particle(const JsonMember& member) {
    const std::string pointer = "/particles/" + escape_pointer_key(member.key);
    const bool sound = source_.sound_at(pointer);
    const std::optional<std::int32_t> id = particle_id(member.key);
    if (!id) {
      source_.report(pointer,
                     fmt::format("the key {} is no id; allowed: an integer from 0 to 2147483647 in digits, "
                                 "without sign, space or leading zero",
                                 in_quotes(member.key)));
    }
    if (!sound) return;
    Particle particle;
    particle.id = id.value_or(0);
    particle.position = read_vector(member, "position", pointer);
    particle.velocity = read_vector(member, "velocity", pointer);
    particle.species = species_index(*member.value.find("species")->string(), pointer + "/species");
    scene_.particles.push_back(particle);
  }

  /// The first particle that is sound decides the dimension.
  Coordinates read_vector(const JsonMember& particle, std::string_view key, const std::string& pointer) {
    const JsonValue::Array& list = *particle.value.find(key)->array();
    if (first_ == nullptr) {
      first_ = &particle;
      scene_.dimension = static_cast<int>(list.size());
    }
    Coordinates vector{};
    if (list.size() != static_cast<std::size_t>(scene_.dimension)) {
      source_.report(fmt::format("{}/{}", pointer, key),
                     fmt::format("found {} numbers; allowed: {}, as in the position of particle {} (line {})",
                                 list.size(), scene_.dimension, in_quotes(first_->key), first_->key_line));
      return vector;
    }
    for (std::size_t k = 0; k < list.size(); ++k) vector[k] = list[k].number()->value;
    return vector;
  }

  int species_index(const std::string& name, const std::string& pointer) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found != names_.end()) return static_cast<int>(found - names_.begin());
    source_.report(pointer, names_.empty()
                                ? fmt::format("no species is named {}; the file has none", in_quotes(name))
                                : fmt::format("no species is named {}; the nearest is {}", in_quotes(name),
                                              in_quotes(nearest_name(name, names_))));
    return 0;
  }

  const JsonValue& root_;
  const ImportOptions& options_;
  SceneSource source_;
  Scene scene_;
  std::vector<std::string> notes_;
  bool with_impulses_ = false;
  std::vector<std::string> names_;  ///< of the species, in the order of the file
  const JsonMember* first_ = nullptr;
};

}  // namespace

ImportedScene import_scenario(JsonDocument document, const ImportOptions& options) {
  embedded_schema("arslab_tps").validate(document.root, document.problems);
  ImportedScene imported = Importer(document.root, document.problems, options).read();
  document.problems.throw_if_any();
  return imported;
}

}  // namespace tps::arslab
