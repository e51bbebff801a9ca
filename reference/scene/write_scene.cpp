#include "reference/scene/write_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"

namespace tps {
namespace {

std::string text(const std::string& value) {
  return json_text(nlohmann::ordered_json(value));
}
std::string text(double value) {
  return std::isinf(value) ? "\"inf\"" : write_shortest(value);
}
std::string text(int value) {
  return std::to_string(value);
}

// Integers above 2^53 are exact in JSON only as strings.
std::string seed_text(std::uint64_t seed) {
  return seed <= (std::uint64_t{1} << 53) ? std::to_string(seed) : fmt::format("\"{}\"", seed);
}

class Writer {
 public:
  Writer(const Scene& scene, SceneStyle style)
      : scene_(scene), pretty_(style == SceneStyle::pretty), comma_(pretty_ ? ", " : ",") {}

  std::string write() const {
    Members members;
    members.emplace_back("tps", "1");
    if (!scene_.title.empty()) members.emplace_back("title", text(scene_.title));
    members.emplace_back("dimension", text(scene_.dimension));
    members.emplace_back("duration", text(scene_.duration));
    if (scene_.start_time != 0 || std::signbit(scene_.start_time)) {
      members.emplace_back("start_time", text(scene_.start_time));
    }
    if (scene_.seed != 0) members.emplace_back("seed", seed_text(scene_.seed));
    members.emplace_back("species", species());
    if (!scene_.pairs.empty()) members.emplace_back("pairs", lines(scene_.pairs));
    if (scene_.grouping) {
      members.emplace_back("grouping", object({{"dt_restitute", text(scene_.grouping->dt_restitute)}}));
    }
    if (scene_.gravity) {
      members.emplace_back("gravity", object({{"acceleration", vector(scene_.gravity->acceleration)},
                                              {"every", text(scene_.gravity->every)}}));
    }
    if (scene_.drag) members.emplace_back("drag", object({{"gamma", text(scene_.drag->gamma)}}));
    if (!scene_.walls.empty()) members.emplace_back("walls", lines(scene_.walls));
    if (scene_.box) members.emplace_back("box", object({{"periodic", vector(scene_.box->edges)}}));
    if (!scene_.phases.empty()) members.emplace_back("phases", lines(scene_.phases));
    if (!scene_.impulses.empty()) members.emplace_back("impulses", lines(scene_.impulses));
    for (const auto& [key, section] : scene_.sections) members.emplace_back(key, section->json());
    members.emplace_back("particles", lines(scene_.particles));
    if (!scene_.tethers.empty()) members.emplace_back("tethers", lines(scene_.tethers));
    if (scene_.clusters) members.emplace_back("observe", object({{"clusters", entry(*scene_.clusters)}}));
    return pretty_ ? block("{", members_text(members), "}", "") + "\n" : object(members);
  }

 private:
  using Members = std::vector<std::pair<std::string, std::string>>;

  std::vector<std::string> members_text(const Members& members) const {
    std::vector<std::string> parts;
    for (const auto& [key, value] : members) parts.push_back(text(key) + (pretty_ ? ": " : ":") + value);
    return parts;
  }
  std::string joined(const std::vector<std::string>& parts) const {
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : comma_) + part;
    return all;
  }
  std::string object(const Members& members) const {
    return fmt::format("{{{}}}", joined(members_text(members)));
  }

  // One part a line, each indented by two spaces more than the line of the brackets.
  static std::string block(const char* open, const std::vector<std::string>& parts, const char* close,
                           const std::string& indent) {
    std::string all = open;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      all += (k > 0 ? ",\n" : "\n") + indent + "  " + parts[k];
    }
    return all + "\n" + indent + close;
  }

  template <typename List>
  std::string lines(const List& list) const {
    std::vector<std::string> parts;
    for (const auto& each : list) parts.push_back(entry(each));
    return pretty_ ? block("[", parts, "]", "  ") : fmt::format("[{}]", joined(parts));
  }

  const std::string& name(int index) const { return scene_.species[static_cast<std::size_t>(index)].name; }
  std::string id(int index) const { return text(scene_.particles[static_cast<std::size_t>(index)].id); }
  std::string between(int a, int b) const {
    return fmt::format("[{}{}{}]", text(name(a)), comma_, text(name(b)));
  }

  std::string vector(const Coordinates& coordinates) const {
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene_.dimension); ++k) {
      parts.push_back(text(coordinates[k]));
    }
    return fmt::format("[{}]", joined(parts));
  }

  std::string species() const {
    Members all;
    for (const Species& each : scene_.species) {
      Members members = {{"mass", text(each.mass)}, {"radius", text(each.radius)}};
      if (each.max_tethers) members.emplace_back("max_tethers", text(*each.max_tethers));
      if (const auto& kicks = each.random_impulses)
        members.emplace_back(
            "random_impulses",
            object({{"tau", text(kicks->tau)}, {"shape", text(kicks->shape)}, {"mean", text(kicks->mean)}}));
      if (const auto& bath = each.thermostat)
        members.emplace_back("thermostat", object({{"tau", text(bath->tau)}, {"kT", text(bath->kT)}}));
      all.emplace_back(each.name, object(members));
    }
    return pretty_ ? block("{", members_text(all), "}", "  ") : object(all);
  }

  std::string rule(const FormRule& form) const {
    switch (form.when) {
      case FormRule::When::never:
        return "\"never\"";
      case FormRule::When::always:
        return "\"always\"";
      case FormRule::When::permanent:
        return "\"permanent\"";
      case FormRule::When::probability:
        break;
    }
    return object({{"probability", text(form.probability)}});
  }
  std::string rule(const BreakRule& breaks) const {
    switch (breaks.when) {
      case BreakRule::When::never:
        return "\"never\"";
      case BreakRule::When::always:
        return "\"always\"";
      case BreakRule::When::impulse_above:
        return object({{"impulse_above", text(breaks.threshold)}});
      case BreakRule::When::probability:
        break;
    }
    return object({{"probability", text(breaks.probability)}});
  }

  std::string entry(const PairLaw& law) const {
    Members members = {{"between", between(law.species_a, law.species_b)}};
    if (law.blocking) {
      members.emplace_back("blocking", object({{"distance", text(law.blocking->distance)},
                                               {"c_rebound", text(law.blocking->c_rebound)}}));
    }
    if (law.friction)
      members.emplace_back("friction",
                           object({{"mu", text(law.friction->mu)}, {"beta0", text(law.friction->beta0)}}));
    if (law.tethering) {
      members.emplace_back("tethering", object({{"distance", text(law.tethering->distance)},
                                                {"c_retract", text(law.tethering->c_retract)},
                                                {"c_revolve", text(law.tethering->c_revolve)},
                                                {"theta_revolve_deg", text(law.tethering->theta_revolve_deg)},
                                                {"form", rule(law.tethering->form)},
                                                {"break", rule(law.tethering->breaks)}}));
    }
    return object(members);
  }
  std::string entry(const Phase& phase) const {
    Members members = {{"from", text(phase.from)},
                       {"until", text(phase.until)},
                       {"between", between(phase.species_a, phase.species_b)}};
    if (phase.form) members.emplace_back("form", rule(*phase.form));
    if (phase.breaks) members.emplace_back("break", rule(*phase.breaks));
    return object(members);
  }
  std::string box_of(const Wall& wall) const {
    Members members{{"low", vector(wall.point)}, {"high", vector(wall.high)}};
    if (!wall.inside) members.emplace_back("side", "\"outside\"");
    return object(members);
  }
  Members shape_of(const Wall& wall) const {
    const std::string point = vector(wall.point);
    switch (wall.shape) {
      case Wall::Shape::plane:
        return {{"plane", object({{"through", point}, {"normal", vector(wall.normal)}})}};
      case Wall::Shape::sphere:
        return {{"sphere", object({{"centre", point},
                                   {"radius", text(wall.radius)},
                                   {"side", wall.inside ? "\"inside\"" : "\"outside\""}})}};
      case Wall::Shape::box:
        return {{"box", box_of(wall)}};
    }
    return {};
  }
  std::string entry(const Wall& wall) const {
    Members members = shape_of(wall);
    members.emplace_back("c_rebound", text(wall.c_rebound));
    if (wall.velocity != Coordinates{}) members.emplace_back("velocity", vector(wall.velocity));
    return object(members);
  }
  std::string entry(const ScheduledImpulse& impulse) const {
    return object(
        {{"at", text(impulse.at)}, {"particle", id(impulse.particle)}, {"impulse", vector(impulse.impulse)}});
  }
  std::string entry(const Particle& particle) const {
    Members members{{"id", text(particle.id)},
                    {"species", text(name(particle.species))},
                    {"position", vector(particle.position)},
                    {"velocity", vector(particle.velocity)}};
    const Coordinates turning =
        spin_of(scene_, static_cast<std::size_t>(&particle - scene_.particles.data()));
    if (turning != Coordinates{}) members.emplace_back("spin", spin(turning));
    return object(members);
  }
  std::string spin(const Coordinates& spin) const {
    if (scene_.dimension == 2) return fmt::format("[{}]", text(spin[0]));
    return vector(spin);
  }
  std::string entry(const Tether& tether) const {
    return fmt::format("[{}{}{}]", id(tether.i), comma_, id(tether.j));
  }
  std::string entry(const ClusterObservation& clusters) const {
    return object({{"species", text(name(clusters.species))}, {"at_least", text(clusters.at_least)}});
  }

  const Scene& scene_;
  bool pretty_;
  std::string comma_;
};

}  // namespace

std::string write_scene(const Scene& scene, SceneStyle style) {
  return Writer(scene, style).write();
}

}  // namespace tps
