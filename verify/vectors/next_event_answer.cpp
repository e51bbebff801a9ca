#include "verify/vectors/next_event_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verify/certified/certified_next_event.hpp"
#include "verify/certified/next_event_input.hpp"
#include "verify/operations/compound_input.hpp"
#include "verify/vectors/enclosure_json.hpp"
#include "verify/vectors/question.hpp"
#include "verify/vectors/time_bracket.hpp"

namespace tps::vectors {
namespace {

/// A certified answer to a scene that is read as every scene is.
certified::NextEventInput read_scene(const Json& in) {
  const Scene scene = operations::read_next_event(question_value(in), {kQuestion, "/in"});
  if (const auto effect = certified::not_certified(scene))
    throw std::invalid_argument(fmt::format("known answers of next_event have no {}", *effect));
  if (scene.grouping) throw std::invalid_argument("known answers of next_event have no grouping");
  for (std::size_t n = 0; n < scene.particles.size(); ++n) {
    if (scene.particles[n].id != static_cast<int>(n)) throw std::invalid_argument("ids must count from 0");
  }
  return certified::next_event_input(scene);
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
  const certified::NextEventInput input = read_scene(in);
  const std::optional<certified::CertifiedNextEvent> event = certified::certified_next_event(input);
  if (!event || event->tied || event->boundary) return std::nullopt;
  const certified::PairLimit& limit = input.limits[event->limit];
  Json answer{{"kind", event->kind}, {"i", limit.i}, {"j", limit.j}};
  add_enclosures(answer, "dt", {event->dt});
  add_enclosures(answer, "positions", in_a_row(event->positions));
  add_enclosures(answer, "velocities", in_a_row(event->velocities));
  answer["cond"] = event_conditions(input, *event);
  return answer;
}

}  // namespace tps::vectors
