#include "reference/run/snapshot.hpp"

#include <cmath>
#include <fstream>
#include <unordered_map>

#include "reference/run/time_since_start.hpp"
#include "reference/run/trace_file.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/input_error.hpp"

namespace tps {
namespace {

bool starts_like_a_scene(const std::string& path) {
  std::ifstream in(path);
  std::string start(16, '\0');
  in.read(start.data(), 16);
  return !start.starts_with("{\"trace\":") && !start.starts_with("{\"checkpoint\":");
}

Snapshot of_scene(Scene scene) {
  Snapshot snapshot;
  for (const Particle& p : scene.particles) snapshot.positions.push_back(p.position);
  snapshot.tethers = scene.tethers;
  snapshot.scene = std::move(scene);
  return snapshot;
}

}  // namespace

Snapshot read_snapshot(const std::string& path, std::optional<double> at) {
  if (path == "-" || starts_like_a_scene(path)) return of_scene(read_scene_file(path));
  Snapshot snapshot;
  snapshot.scene = read_trace_head(path).scene;
  const StateData state = last_state_until(path, snapshot.scene, at);
  if (state.checksum == StateData::Checksum::wrong) {
    throw InputError(
        {{path, 0, "",
          "its last full state has the checksum of another: it was damaged, or edited; if it was "
          "edited, leave the checksum out"}});
  }
  snapshot.t = time_since_start(snapshot.scene, state.now);
  const double now = nearest(state.now);  // on the clock of positions: with drag not t
  std::unordered_map<std::int32_t, int> index_of;
  for (const Particle& p : snapshot.scene.particles) {
    index_of.emplace(p.id, static_cast<int>(index_of.size()));
  }
  snapshot.positions.resize(index_of.size());
  try {
    for (const StateData::Particle& p : state.particles) {
      std::array<double, 3>& position = snapshot.positions[static_cast<std::size_t>(index_of.at(p.id))];
      const double flight = now - nearest(p.clock);
      for (std::size_t k = 0; k < p.position.size() && k < 3; ++k) {
        position[k] = nearest(p.position.at(k)) + nearest(p.velocity.at(k)) * flight;
        if (!std::isfinite(position[k])) {
          const std::string id = std::to_string(p.id);
          throw InputError(
              {{path, 0, "", "its full state puts particle " + id + " beyond the range of a double"}});
        }
      }
    }
    for (const auto& [first, second] : state.tethers) {
      snapshot.tethers.push_back({index_of.at(first), index_of.at(second)});
    }
  } catch (const std::out_of_range&) {
    throw InputError({{path, 0, "", "its full state does not fit its scene"}});
  }
  return snapshot;
}

}  // namespace tps
