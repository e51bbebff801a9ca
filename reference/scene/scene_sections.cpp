#include "reference/scene/scene_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "reference/scene/read_pair_law.hpp"
#include "reference/scene/read_spins.hpp"
#include "reference/scene/read_wall.hpp"
#include "reference/scene/scene_key.hpp"
#include "reference/scene/scene_values.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

const JsonValue::Array& entries(const JsonValue& root, std::string_view key) {
  static const JsonValue::Array none;
  const JsonValue* value = root.find(key);
  return value == nullptr || value->array() == nullptr ? none : *value->array();
}

class Sections {
 public:
  explicit Sections(SceneSource& source) : source_(source), root_(source.root()) {}

  Scene read() {
    if (source_.full()) return scene_;
    read_top_level();
    const bool named = root_.find("species") != nullptr && source_.sound({"species"});
    if (named) read_species();
    if (named) read_pairs();
    if (named) read_phases();
    if (named && source_.sound({"observe"})) read_observe();
    const bool measured = root_.find("dimension") != nullptr && source_.sound({"dimension"});
    if (!named || !measured) return scene_;
    read_particles();
    if (root_.find("particles") == nullptr || !source_.sound({"particles"})) return scene_;
    read_spins(scene_, source_);
    read_gravity();
    read_walls();
    read_box();
    read_impulses();
    read_tethers();
    read_keys_of_effects(scene_, source_);
    return scene_;
  }

 private:
  void read_top_level() {
    const auto there = [&](std::string_view key) {
      return root_.find(key) != nullptr && source_.sound({key});
    };
    if (there("title")) scene_.title = *root_.find("title")->string();
    if (there("dimension")) scene_.dimension = integer_of(*root_.find("dimension"));
    if (there("start_time")) scene_.start_time = number_at(root_, "start_time");
    if (there("duration")) scene_.duration = number_at(root_, "duration");
    if (there("seed")) scene_.seed = json_uint64(*root_.find("seed")).value();
    if (there("drag")) scene_.drag = Drag{number_at(*root_.find("drag"), "gamma")};
    if (there("grouping")) scene_.grouping = Grouping{number_at(*root_.find("grouping"), "dt_restitute")};
  }

  void read_species() {
    for (const JsonMember& member : *root_.find("species")->object()) {
      Species species;
      species.name = member.key;
      species.mass = number_at(member.value, "mass");
      species.radius = number_at(member.value, "radius");
      if (const JsonValue* most = member.value.find("max_tethers")) species.max_tethers = integer_of(*most);
      if (const JsonValue* kicks = member.value.find("random_impulses"))
        species.random_impulses =
            RandomImpulses{number_at(*kicks, "tau"), number_at(*kicks, "shape"), number_at(*kicks, "mean")};
      if (const JsonValue* bath = member.value.find("thermostat"))
        species.thermostat = Thermostat{number_at(*bath, "tau"), number_at(*bath, "kT")};
      index_of_.emplace(species.name, static_cast<int>(scene_.species.size()));
      names_.push_back(species.name);
      scene_.species.push_back(species);
    }
  }

  // Whether the schema accepted an entry of a list. An entry that is wrong does not keep the others from
  // being looked at; nothing that needs the whole list is done with the rest.
  bool sound(const std::string& pointer) const { return source_.sound_at(pointer); }

  // Index of a species by its name; reports a name that no species has.
  std::optional<int> species_index(const JsonValue& value, const std::string& pointer) {
    const auto found = index_of_.find(*value.string());
    if (found != index_of_.end()) return found->second;
    source_.report(pointer,
                   fmt::format("no species is named {}; the nearest is {}", in_quotes(*value.string()),
                               in_quotes(nearest_name(*value.string(), names_))));
    return std::nullopt;
  }

  // The two species of a "between", the smaller index first.
  std::optional<std::pair<int, int>> read_between(const JsonValue& entry, const std::string& pointer) {
    const JsonValue::Array& between = *entry.find("between")->array();
    const std::optional<int> a = species_index(between[0], pointer + "/between/0");
    const std::optional<int> b = species_index(between[1], pointer + "/between/1");
    if (!a || !b) return std::nullopt;
    return std::minmax({*a, *b});
  }

  const Species& species(int index) const { return scene_.species[static_cast<std::size_t>(index)]; }

  void read_pairs() {
    const JsonValue::Array& list = entries(root_, "pairs");
    std::map<std::pair<int, int>, std::size_t> entry_of;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string pointer = fmt::format("/pairs/{}", k);
      if (!sound(pointer)) continue;
      const std::optional<std::pair<int, int>> pair = read_between(list[k], pointer);
      if (!pair) continue;
      const auto [first, is_new] = entry_of.emplace(*pair, k);
      if (!is_new) {
        source_.report(
            pointer + "/between",
            fmt::format("the pair {} and {} stands in /pairs/{} (line {}) already; join the two "
                        "entries",
                        in_quotes(species(pair->first).name), in_quotes(species(pair->second).name),
                        first->second, list[first->second].line));
        continue;
      }
      scene_.pairs.push_back(read_pair_law(list[k], scene_.species, *pair));
    }
  }

  void read_phases() {
    const JsonValue::Array& list = entries(root_, "phases");
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string pointer = fmt::format("/phases/{}", k);
      if (!sound(pointer)) continue;
      const std::optional<std::pair<int, int>> pair = read_between(list[k], pointer);
      if (!pair) continue;
      Phase phase;
      phase.from = number_at(list[k], "from");
      phase.until = number_at(list[k], "until");
      phase.species_a = pair->first;
      phase.species_b = pair->second;
      if (const JsonValue* form = list[k].find("form")) phase.form = read_form(*form);
      if (const JsonValue* breaks = list[k].find("break")) phase.breaks = read_break(*breaks);
      scene_.phases.push_back(phase);
    }
  }

  void read_observe() {
    const JsonValue* observe = root_.find("observe");
    const JsonValue* clusters = observe == nullptr ? nullptr : observe->find("clusters");
    if (clusters == nullptr) return;
    const std::optional<int> counted = species_index(*clusters->find("species"), "/observe/clusters/species");
    if (!counted) return;
    const JsonValue* least = clusters->find("at_least");
    scene_.clusters = ClusterObservation{*counted, least == nullptr ? 3 : integer_of(*least)};
  }

  Coordinates read_vector(const JsonValue& value, const std::string& pointer) {
    const JsonValue::Array& list = *value.array();
    Coordinates vector{};
    if (list.size() != static_cast<std::size_t>(scene_.dimension)) {
      source_.report(pointer, fmt::format("found {} numbers; allowed: {}, the dimension of the scene",
                                          list.size(), scene_.dimension));
      return vector;
    }
    for (std::size_t k = 0; k < list.size(); ++k) vector[k] = json_number(list[k]).value();
    return vector;
  }

  void read_particles() {
    const JsonValue::Array& list = entries(root_, "particles");
    std::vector<Particle> unsorted;
    std::map<std::int32_t, std::size_t> entry_of;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string pointer = fmt::format("/particles/{}", k);
      if (!sound(pointer)) continue;
      Particle particle;
      const JsonValue* id = list[k].find("id");
      particle.id = id == nullptr ? static_cast<std::int32_t>(k) : integer_of(*id);
      const auto [first, is_new] = entry_of.emplace(particle.id, k);
      if (!is_new) {
        source_.report(
            pointer + "/id",
            fmt::format("the id {} belongs to /particles/{} (line {}) already; ids are unique, and "
                        "an entry without one has its place in the list, counted from 0, for id",
                        particle.id, first->second, list[first->second].line));
      }
      particle.species = species_index(*list[k].find("species"), pointer + "/species").value_or(0);
      particle.position = read_vector(*list[k].find("position"), pointer + "/position");
      const JsonValue* velocity = list[k].find("velocity");
      if (velocity != nullptr) particle.velocity = read_vector(*velocity, pointer + "/velocity");
      unsorted.push_back(particle);
    }
    source_.particle_entries.resize(unsorted.size());
    std::iota(source_.particle_entries.begin(), source_.particle_entries.end(), std::size_t{0});
    std::stable_sort(source_.particle_entries.begin(), source_.particle_entries.end(),
                     [&](std::size_t a, std::size_t b) { return unsorted[a].id < unsorted[b].id; });
    for (const std::size_t k : source_.particle_entries) scene_.particles.push_back(unsorted[k]);
  }

  // Index of a particle by its id; reports an id that no particle has.
  std::optional<int> particle_index(const JsonValue& value, const std::string& pointer) {
    const int id = integer_of(value);
    const auto found =
        std::lower_bound(scene_.particles.begin(), scene_.particles.end(), id,
                         [](const Particle& particle, int wanted) { return particle.id < wanted; });
    if (found != scene_.particles.end() && found->id == id) {
      return static_cast<int>(found - scene_.particles.begin());
    }
    source_.report(pointer, fmt::format("no particle has the id {}; ids in use lie from {} to {}", id,
                                        scene_.particles.front().id, scene_.particles.back().id));
    return std::nullopt;
  }

  void read_gravity() {
    const JsonValue* gravity = root_.find("gravity");
    if (gravity == nullptr || !source_.sound({"gravity"})) return;
    scene_.gravity = Gravity{read_vector(*gravity->find("acceleration"), "/gravity/acceleration"),
                             number_at(*gravity, "every")};
  }

  void read_walls() {
    const JsonValue::Array& list = entries(root_, "walls");
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string pointer = fmt::format("/walls/{}", k);
      const auto vector = [this](const JsonValue& value, const std::string& at) {
        return read_vector(value, at);
      };
      if (!sound(pointer)) continue;
      if (has_one_shape(list[k])) {
        scene_.walls.push_back(read_wall(list[k], pointer, vector));
      } else {
        source_.report(pointer, "a wall is one plane, sphere or box; make an entry of each");
      }
    }
  }

  void read_box() {
    const JsonValue* box = root_.find("box");
    if (box == nullptr || !source_.sound({"box"})) return;
    PeriodicEdges periodic{read_vector(*box->find("periodic"), "/box/periodic")};
    for (std::size_t k = static_cast<std::size_t>(scene_.dimension); k < periodic.edges.size(); ++k)
      periodic.edges[k] = std::numeric_limits<double>::infinity();
    scene_.box = periodic;
  }

  void read_impulses() {
    const JsonValue::Array& list = entries(root_, "impulses");
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string pointer = fmt::format("/impulses/{}", k);
      if (!sound(pointer)) continue;
      ScheduledImpulse impulse;
      impulse.at = number_at(list[k], "at");
      impulse.particle = particle_index(*list[k].find("particle"), pointer + "/particle").value_or(0);
      impulse.impulse = read_vector(*list[k].find("impulse"), pointer + "/impulse");
      scene_.impulses.push_back(impulse);
    }
  }

  void read_tethers() {
    const JsonValue::Array& list = entries(root_, "tethers");
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (!sound(fmt::format("/tethers/{}", k))) continue;
      const JsonValue::Array& ids = *list[k].array();
      const std::optional<int> i = particle_index(ids[0], fmt::format("/tethers/{}/0", k));
      const std::optional<int> j = particle_index(ids[1], fmt::format("/tethers/{}/1", k));
      if (i && j) scene_.tethers.push_back({std::min(*i, *j), std::max(*i, *j)});
    }
  }

  SceneSource& source_;
  const JsonValue& root_;
  Scene scene_;
  std::map<std::string, int, std::less<>> index_of_;
  std::vector<std::string> names_;
};

}  // namespace

Scene read_sections(SceneSource& source) {
  return Sections(source).read();
}

}  // namespace tps
