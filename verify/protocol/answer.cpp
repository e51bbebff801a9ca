#include "verify/protocol/answer.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reference/run/next_event.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/certified/certified_next_event.hpp"
#include "verify/certified/certified_response.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/certified/next_event_input.hpp"
#include "verify/exact/rounded_drag_time.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/operations/compound_input.hpp"
#include "verify/operations/no_answer.hpp"
#include "verify/protocol/simulate.hpp"

namespace tps::protocol {
namespace {

using Json = nlohmann::ordered_json;
using operations::Input;
using operations::Op;
using operations::Operation;
using operations::Place;

Json numbers(const std::vector<double>& components) {
  Json list = Json::array();
  for (const double x : components) list.push_back(to_hex(x));
  return list;
}

/// The correctly rounded components.
Json numbers(const certified::EnclosedVector& components) {
  Json list = Json::array();
  for (const certified::Enclosure& x : components) list.push_back(to_hex(x.nearest));
  return list;
}

Json timing_json(const exact::TimingAnswer& answer) {
  return {{"verdict", name(answer.verdict)}, {"t", answer.t ? Json(to_hex(*answer.t)) : Json()}};
}

/// Whether every component is proven to be the nearest double.
bool settled(const certified::EnclosedVector& components) {
  return std::all_of(components.begin(), components.end(),
                     [](const certified::Enclosure& x) { return x.settled; });
}

/// Flags are there only where they are set.
void flag(Json& answer, const char* name, bool set) {
  if (set) answer[name] = true;
}

Json response_json(const certified::Response& response) {
  Json answer = Json::object();
  if (!response.kind.empty()) answer["kind"] = response.kind;
  bool all_settled = true;
  for (const auto& [key, components] : response.values) {
    all_settled = all_settled && settled(components);
    answer[key] = numbers(components);
  }
  flag(answer, "boundary", response.boundary);
  flag(answer, "unsettled", !all_settled);
  return answer;
}

Json velocities_json(const std::vector<certified::EnclosedVector>& velocities) {
  Json list = Json::array();
  for (const certified::EnclosedVector& v : velocities) list.push_back(numbers(v));
  return list;
}

Json group_json(const certified::GroupResponse& response) {
  Json answer = {{"loaded", velocities_json(response.loaded)},
                 {"restituted", velocities_json(response.restituted)}};
  flag(answer, "boundary", response.boundary);
  flag(answer, "unsettled",
       !std::all_of(response.loaded.begin(), response.loaded.end(), settled) ||
           !std::all_of(response.restituted.begin(), response.restituted.end(), settled));
  return answer;
}

template <typename Components>
Json state_json(std::int32_t id, const Components& position, const Components& velocity) {
  return {{"id", id}, {"position", numbers(position)}, {"velocity", numbers(velocity)}};
}

/// An event of the engine, under certified timing from the scene's own numbers: who and when are exact, the
/// state after it is computed in double.
Json simulated_json(const NextEvent& event) {
  Json answer = {{"kind", event.kind}};
  if (event.i) answer["i"] = *event.i;
  if (event.j) answer["j"] = *event.j;
  if (event.dt) answer["dt"] = to_hex(*event.dt);
  if (!event.tether.empty()) answer["tether"] = event.tether;
  Json& state = answer["state"] = Json::array();
  for (const NextEvent::State& s : event.state) state.push_back(state_json(s.id, s.position, s.velocity));
  answer["simulated"] = true;
  return answer;
}

Json nothing_json(const Scene& scene) {
  Json answer = {{"kind", "none"}, {"state", Json::array()}};
  for (const Particle& p : scene.particles) {
    const auto components = [&](const Coordinates& x) {
      return std::vector<double>(x.begin(), x.begin() + scene.dimension);
    };
    answer["state"].push_back(state_json(p.id, components(p.position), components(p.velocity)));
  }
  return answer;
}

Json event_json(const Scene& scene, const certified::PairLimit& limit,
                const certified::CertifiedNextEvent& event) {
  Json answer = {{"kind", event.kind},
                 {"i", scene.particles[limit.i].id},
                 {"j", scene.particles[limit.j].id},
                 {"dt", to_hex(event.dt.nearest)}};
  if (!event.tether.empty()) answer["tether"] = event.tether;
  Json& state = answer["state"] = Json::array();
  for (std::size_t n = 0; n < scene.particles.size(); ++n)
    state.push_back(state_json(scene.particles[n].id, event.positions[n], event.velocities[n]));
  flag(answer, "boundary", event.boundary);
  flag(answer, "tied", event.tied);
  flag(answer, "unsettled", !event.settled);
  return answer;
}

Json drag(const Input& input) {
  const double gamma = input.values.at("gamma")[0], s = input.values.at("s")[0];
  if (!exact::drag_clock_is_reached(gamma, s)) return {{"verdict", "never"}, {"t", nullptr}};
  const exact::DragTime time = exact::rounded_drag_time(gamma, s);
  Json answer = {{"verdict", "reached"}, {"t", to_hex(time.t)}};
  flag(answer, "unsettled", !time.settled);
  return answer;
}

Json timing(const Operation& operation, const JsonValue& in, const Place& place) {
  const Input input = operations::read_value(operation, in, place);
  if (operation.op == Op::drag_time) return drag(input);
  exact::Counters uncounted;
  const exact::Kind kind = operations::timing_kind(operation.op).value();
  return timing_json(exact::rounded_time(operations::TimingInput{kind, input}.query(), uncounted));
}

Json response(const Operation& operation, const JsonValue& in, const Place& place) {
  return response_json(
      certified::certified_response(operation.op, operations::read_value(operation, in, place)));
}

Json group(const JsonValue& in, const Place& place) {
  return group_json(certified::certified_group(operations::read_group(in, place)));
}

Json next_event(const JsonValue& in, const Place& place) {
  const Scene scene = operations::read_next_event(in, place);
  if (certified::not_certified(scene)) {
    certified::ExactTiming certifier;
    try {
      return simulated_json(tps::next_event(scene, {Timing::certified, &certifier}));
    } catch (const InputError& error) {  // knows the scene, not where it stands
      throw InputError({{place.source, in.line, place.pointer, error.problems().front().message}});
    }
  }
  const certified::NextEventInput input = certified::next_event_input(scene);
  const auto event = certified::certified_next_event(input);
  return event ? event_json(scene, input.limits[event->limit], *event) : nothing_json(scene);
}

}  // namespace

const std::vector<std::string>& operation_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Operation& operation : operations::catalogue()) {
      if (operation.is_certified) all.emplace_back(operation.name);
    }
    return all;
  }();
  return names;
}

Json answer_order(const operations::OrderInput& input) {
  exact::Counters uncounted;
  const exact::Order order = exact::time_order(input.first.query(), input.second.query(), uncounted);
  return {{"order", exact::name(order)}};
}

Json answer(Op op, const JsonValue& in, const Place& place) try {
  const Operation& operation = operations::operation(op);
  switch (operation.answers) {
    case operations::Answers::time:
      return timing(operation, in, place);
    case operations::Answers::response:
      return response(operation, in, place);
    case operations::Answers::order:
      return answer_order(operations::read_order(in, place));
    case operations::Answers::group:
      return group(in, place);
    case operations::Answers::event:
      return next_event(in, place);
    case operations::Answers::number:
    case operations::Answers::trace:
      break;
  }
  throw std::invalid_argument(std::string(operation.name) + " has no certified value");
} catch (const operations::NoAnswer& why) {
  throw why.in(place.source, in.line, place.pointer);
}

std::string answer_text(Op op, const JsonValue& in, const Place& place) {
  if (operations::operation(op).answers == operations::Answers::trace) return simulate(in, place);
  return json_text(answer(op, in, place));
}

}  // namespace tps::protocol
