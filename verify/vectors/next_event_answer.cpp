#include "verify/vectors/next_event_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "verify/certified/certified_next_event.hpp"
#include "verify/vectors/enclosure_json.hpp"
#include "verify/vectors/time_bracket.hpp"

namespace tps::vectors {
namespace {

const Json& law_between(const Json& pairs, const Json& one, const Json& other) {
  static const Json none;
  for (const Json& pair : pairs) {
    const Json& between = pair.at("between");
    if ((between.at(0) == one && between.at(1) == other) || (between.at(0) == other && between.at(1) == one))
      return pair;
  }
  return none;
}

bool tethered(const Json& scene, std::size_t i, std::size_t j) {
  const Json tethers = scene.value("tethers", Json::array());
  return std::any_of(tethers.begin(), tethers.end(), [&](const Json& pair) {
    return (pair.at(0) == i && pair.at(1) == j) || (pair.at(0) == j && pair.at(1) == i);
  });
}

certified::NextEventInput read_scene(const Json& scene) {
  static const std::set<std::string> known{"tps",   "dimension", "duration", "species",
                                           "pairs", "particles", "tethers"};
  for (const auto& [key, value] : scene.items()) {
    if (!known.contains(key))
      throw std::invalid_argument(fmt::format("known answers of next_event have no {}", key));
  }
  certified::NextEventInput input;
  const Json& particles = scene.at("particles");
  for (std::size_t n = 0; n < particles.size(); ++n) {
    const Json& particle = particles.at(n);
    if (particle.at("id") != n) throw std::invalid_argument("ids must count from 0");
    const Json& species = scene.at("species").at(particle.at("species").get<std::string>());
    input.bodies.push_back({read_number(species.at("mass")), read_vector(particle.at("position")),
                            read_vector(particle.at("velocity"))});
  }
  for (std::size_t i = 0; i < particles.size(); ++i) {
    for (std::size_t j = i + 1; j < particles.size(); ++j) {
      if (std::isinf(input.bodies[i].mass) && std::isinf(input.bodies[j].mass)) continue;
      const Json& law =
          law_between(scene.at("pairs"), particles.at(i).at("species"), particles.at(j).at("species"));
      if (law.is_null()) continue;
      const Json& blocking = law.at("blocking");
      input.limits.push_back({i, j, exact::Kind::block, read_number(blocking.at("distance")),
                              read_number(blocking.at("c_rebound"))});
      if (!tethered(scene, i, j)) continue;
      const Json& tether = law.at("tethering");
      input.limits.push_back({i, j, exact::Kind::tether, read_number(tether.at("distance")),
                              read_number(tether.at("c_retract")), read_number(tether.at("c_revolve")),
                              read_number(tether.at("theta_revolve_deg"))});
    }
  }
  return input;
}

certified::EnclosedVector in_a_row(const std::vector<certified::EnclosedVector>& vectors) {
  certified::EnclosedVector row;
  for (const certified::EnclosedVector& x : vectors) row.insert(row.end(), x.begin(), x.end());
  return row;
}

double largest(const std::vector<certified::EnclosedVector>& vectors) {
  double size = 0;
  for (const certified::EnclosedVector& x : vectors) {
    for (const certified::Enclosure& e : x) size = std::max(size, std::fabs(e.nearest));
  }
  return size;
}

/// dt as in a timing case. An error of dt moves the bodies by v dt, and so turns the normal by v dt / L,
/// which changes velocities by as much of the relative one.
Json event_conditions(const certified::NextEventInput& input, const certified::CertifiedNextEvent& event) {
  const certified::PairLimit& limit = input.limits[event.limit];
  const exact::TimingQuery query = certified::timing_query(input, limit);
  const double of_time = condition(query, prove(query)).value_or(1);
  const double fastest = largest(event.velocities);
  const double way = of_time * event.dt.nearest * fastest;
  const double positions = largest(event.positions);
  return {{"dt", rounded_condition(of_time)},
          {"positions", rounded_condition(1 + way / positions)},
          {"velocities", rounded_condition(4 * (1 + way / limit.L))}};
}

}  // namespace

std::optional<Json> next_event_answer(const Json& in) {
  const certified::NextEventInput input = read_scene(in.at("scene"));
  const std::optional<certified::CertifiedNextEvent> event = certified::certified_next_event(input);
  if (!event) return std::nullopt;
  const certified::PairLimit& limit = input.limits[event->limit];
  Json answer{{"kind", event->kind}, {"i", limit.i}, {"j", limit.j}};
  add_enclosures(answer, "dt", {event->dt});
  add_enclosures(answer, "positions", in_a_row(event->positions));
  add_enclosures(answer, "velocities", in_a_row(event->velocities));
  answer["cond"] = event_conditions(input, *event);
  return answer;
}

}  // namespace tps::vectors
