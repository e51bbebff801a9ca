// Scenarios of the public program ARSLab_TPS as scenes of ours. The format, what is kept and what is lost:
// docs/import.md and data/schemas/arslab_tps.schema.json.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/text/json_document.hpp"

namespace tps::arslab {

/// What the file does not say, or what the user overrides.
struct ImportOptions {
  std::optional<double> c_rebound;     ///< in [0, 1]; none: 1
  std::optional<double> dt_restitute;  ///< in (0, ∞); none: no grouping
  std::optional<double> duration;      ///< in (0, ∞]; none: config.runtime, or 25 where the file has none
  bool without_random_impulses = false;
};

struct ImportedScene {
  Scene scene;
  std::vector<std::string> notes;  ///< what was assumed or dropped, a sentence each
};

/// What a file may cost: with these limits every scene that is imported is one that read_scene takes.
constexpr JsonLimits import_limits = {.max_values = 3'000'000};
constexpr std::size_t max_species = 100;
constexpr std::size_t max_species_name = 200;  ///< bytes

/// The scene of a scenario. Ids, names and numbers are kept; every pair of species whose radii have a sum
/// above 0 gets a blocking law at that sum, correctly rounded.
/// (1) read_scene_text(write_scene(import_scenario(d, o).scene)) == import_scenario(d, o).scene.
/// Throws InputError with everything that is wrong, in terms of the imported file.
ImportedScene import_scenario(JsonDocument document, const ImportOptions& options);

}  // namespace tps::arslab
