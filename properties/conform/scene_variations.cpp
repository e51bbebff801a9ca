#include "properties/conform/scene_variations.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/conform/expected.hpp"
#include "properties/conform/mistakes.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/pair_law.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/scratch_file.hpp"

namespace tps::properties::conform {
namespace {

template <typename Item>
const Item& one_of(const std::vector<Item>& items, rc::Random& stream) {
  return items[stream.next() % items.size()];
}

bool can_form(const PairLaw& law) {
  return law.blocking && law.tethering && law.tethering->form.when != FormRule::When::permanent;
}

/// Pairs of species by their indices in the scene's pairs, with |Δp| of their outer collisions, in order.
using Pulls = std::map<std::size_t, std::vector<double>>;

/// Of a pair of particles that interact.
std::size_t law_of(const Scene& scene, int i, int j) {
  const auto species = [&](int id) {
    return std::find_if(scene.particles.begin(), scene.particles.end(),
                        [id](const Particle& p) { return p.id == id; })
        ->species;
  };
  return static_cast<std::size_t>(pair_law(scene.pairs, species(i), species(j)) - scene.pairs.data());
}

Pulls pulls_in_run(const Scene& scene, std::uint64_t most_events) {
  const ScratchFile file;
  RunOptions options;
  options.max_events = most_events;
  options.trace = file.path();
  run_scene(scene, options);
  std::istringstream lines(file.content());
  Pulls pulls;
  for (std::string line; std::getline(lines, line);) {
    const Json event = parse_plain_json(line, "trace");
    const std::string kind = event.value("kind", "");
    if (kind != "retract" && kind != "revolve") continue;
    const double size = norm(numbers_of(event.at("dp")).value());
    pulls[law_of(scene, event.at("i").get<int>(), event.at("j").get<int>())].push_back(size);
  }
  return pulls;
}

/// Walls and friction know particles by their radii.
bool radii_matter(const Scene& scene) {
  return !scene.walls.empty() ||
         std::ranges::any_of(scene.pairs, [](const PairLaw& law) { return law.friction.has_value(); });
}

/// Those that exceed all before them.
std::vector<double> records(const std::vector<double>& sizes) {
  std::vector<double> found;
  for (const double size : sizes) {
    if (size > (found.empty() ? 0 : found.back())) found.push_back(size);
  }
  return found;
}

}  // namespace

bool once_in(std::uint64_t many, rc::Random& stream) {
  return stream.next() % many == 0;
}

Scene untethered(Scene scene, const Wishes& wanted, rc::Random& stream) {
  if (!wanted.changing_tethers || !once_in(2, stream)) return scene;
  bool any = false;
  for (PairLaw& law : scene.pairs) {
    if (!can_form(law)) continue;
    any = true;
    if (law.tethering->form.when == FormRule::When::never) law.tethering->form = {FormRule::When::always, 1};
  }
  if (!any) return scene;
  scene.tethers.clear();
  for (Species& species : scene.species) {
    if (std::isfinite(species.mass) && once_in(2, stream))
      species.max_tethers = 1 + static_cast<int>(stream.next() % 2);
  }
  return scene;
}

Scene with_near_threshold(Scene scene, const Wishes& wanted, rc::Random& stream) {
  constexpr std::uint64_t kMostEvents = 100;
  if (!wanted.changing_tethers || !scene.phases.empty() || scene.drag || !once_in(2, stream)) return scene;
  Scene unbroken = scene;
  for (PairLaw& law : unbroken.pairs) {
    if (law.tethering && law.tethering->form.when != FormRule::When::permanent) law.tethering->breaks = {};
  }
  std::vector<std::pair<std::size_t, double>> choices;
  for (const auto& [law, sizes] : pulls_in_run(unbroken, kMostEvents)) {
    if (unbroken.pairs[law].tethering->form.when == FormRule::When::permanent) continue;
    for (const double size : records(sizes)) choices.emplace_back(law, size);
  }
  if (choices.empty()) return scene;
  const auto& [law, size] = one_of(choices, stream);
  BreakRule rule;
  rule.when = BreakRule::When::impulse_above;
  rule.threshold = size * (once_in(2, stream) ? 1.01 : 0.99);
  unbroken.pairs[law].tethering->breaks = rule;
  return unbroken;
}

Scene with_other_limits(Scene scene, const Wishes& wanted, rc::Random& stream) {
  const double factor = one_of<double>({1, 1, 0.25, 0.5, 2}, stream);
  if (!radii_matter(scene)) {
    for (Species& species : scene.species) species.radius *= factor;
  }
  if (!wanted.tethers) return scene;
  for (std::size_t n = 0; n < scene.pairs.size(); ++n) {
    if (!can_form(scene.pairs[n])) continue;
    Scene tied = scene;
    PairLaw& law = tied.pairs[n];
    law.tethering->form = {FormRule::When::permanent, 1};
    law.tethering->breaks = {};
    const auto is_of = [&law](int a, int b) {
      return std::minmax(a, b) == std::minmax(law.species_a, law.species_b);
    };
    std::erase_if(tied.tethers, [&](const Tether& tether) {
      const auto species = [&](int i) { return tied.particles[static_cast<std::size_t>(i)].species; };
      return is_of(species(tether.i), species(tether.j));
    });
    std::erase_if(tied.phases, [&](const Phase& phase) { return is_of(phase.species_a, phase.species_b); });
    try {
      scene = read_scene_text(write_scene(tied), "tied for ever");
    } catch (const InputError&) {
      continue;  // somebody starts too far away
    }
  }
  return scene;
}

Scene with_other_ids(Scene scene, rc::Random& stream) {
  std::vector<std::int32_t> ids;
  for (std::size_t n = 0; n < scene.particles.size(); ++n)
    ids.push_back(static_cast<std::int32_t>(3 * n + 2));
  for (std::size_t n = ids.size(); n > 1; --n) std::swap(ids[n - 1], ids[stream.next() % n]);
  for (std::size_t n = 0; n < ids.size(); ++n) scene.particles[n].id = ids[n];
  return read_scene_text(write_scene(scene), "renamed");
}

Scene with_start_time(Scene scene, const Wishes& wanted, rc::Random& stream) {
  // Near 0: who writes a time into one double loses what the start takes of it.
  if (wanted.start_time && once_in(2, stream)) scene.start_time = one_of<double>({0.75, -2.5, 16}, stream);
  return scene;
}

}  // namespace tps::properties::conform
