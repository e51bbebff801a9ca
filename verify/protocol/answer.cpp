#include "verify/protocol/answer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/run/next_event.hpp"
#include "reference/text/input_error.hpp"
#include "verify/certified/certified_next_event.hpp"
#include "verify/certified/certified_response.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/certified/next_event_input.hpp"
#include "verify/eval/no_answer.hpp"
#include "verify/exact/rounded_drag_time.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/protocol/catalogue.hpp"
#include "verify/protocol/json_text.hpp"
#include "verify/protocol/read_input.hpp"
#include "verify/protocol/simulate.hpp"

namespace tps::protocol {
namespace {

std::string timing_text(const exact::TimingAnswer& answer) {
  return fmt::format(R"({{"verdict":"{}","t":{}}})", name(answer.verdict),
                     answer.t ? quoted_number(*answer.t) : "null");
}

/// Whether every component is proven to be the nearest double.
bool settled(const certified::EnclosedVector& components) {
  return std::all_of(components.begin(), components.end(),
                     [](const certified::Enclosure& x) { return x.settled; });
}

std::string flag(const char* name, bool set) {
  return set ? fmt::format(R"(,"{}":true)", name) : "";
}

std::string response_text(const certified::Response& response) {
  std::string text;
  if (!response.kind.empty()) text = fmt::format(R"("kind":"{}")", response.kind);
  bool all_settled = true;
  for (const auto& [key, components] : response.values) {
    all_settled = all_settled && settled(components);
    text += fmt::format(R"({}"{}":{})", text.empty() ? "" : ",", key, vector_text(components));
  }
  return "{" + text + flag("boundary", response.boundary) + flag("unsettled", !all_settled) + "}";
}

std::string velocities_text(const std::vector<certified::EnclosedVector>& velocities) {
  std::string text;
  for (const certified::EnclosedVector& v : velocities)
    text.append(text.empty() ? "[" : ",").append(vector_text(v));
  return text.empty() ? "[]" : text + "]";
}

std::string group_text(const certified::GroupResponse& response) {
  const bool all_settled = std::all_of(response.loaded.begin(), response.loaded.end(), settled) &&
                           std::all_of(response.restituted.begin(), response.restituted.end(), settled);
  return fmt::format(R"({{"loaded":{},"restituted":{}{}{}}})", velocities_text(response.loaded),
                     velocities_text(response.restituted), flag("boundary", response.boundary),
                     flag("unsettled", !all_settled));
}

template <typename Components>
std::string state_text(const char* separator, std::int32_t id, const Components& position,
                       const Components& velocity) {
  return fmt::format(R"({}{{"id":{},"position":{},"velocity":{}}})", separator, id, vector_text(position),
                     vector_text(velocity));
}

/// An event of the engine, under certified timing from the scene's own numbers: who and when are exact, the
/// state after it is computed in double.
std::string simulated_text(const NextEvent& event) {
  std::string text = fmt::format(R"({{"kind":"{}")", event.kind);
  if (event.i) text += fmt::format(R"(,"i":{})", *event.i);
  if (event.j) text += fmt::format(R"(,"j":{})", *event.j);
  if (event.dt) text += fmt::format(R"(,"dt":{})", quoted_number(*event.dt));
  if (!event.tether.empty()) text += fmt::format(R"(,"tether":"{}")", event.tether);
  text += R"(,"state":[)";
  const char* separator = "";
  for (const NextEvent::State& s : event.state) {
    text += state_text(separator, s.id, s.position, s.velocity);
    separator = ",";
  }
  return text + R"(],"simulated":true})";
}

std::string nothing_text(const Scene& scene) {
  std::string text = R"({"kind":"none","state":[)";
  const char* separator = "";
  for (const Particle& p : scene.particles) {
    const auto components = [&](const Coordinates& x) {
      return std::vector<double>(x.begin(), x.begin() + scene.dimension);
    };
    text += state_text(separator, p.id, components(p.position), components(p.velocity));
    separator = ",";
  }
  return text + "]}";
}

std::string event_text(const Scene& scene, const certified::PairLimit& limit,
                       const certified::CertifiedNextEvent& event) {
  std::string text =
      fmt::format(R"({{"kind":"{}","i":{},"j":{},"dt":{})", event.kind, scene.particles[limit.i].id,
                  scene.particles[limit.j].id, quoted_number(event.dt.nearest));
  if (!event.tether.empty()) text += fmt::format(R"(,"tether":"{}")", event.tether);
  text += R"(,"state":[)";
  const char* separator = "";
  for (std::size_t n = 0; n < scene.particles.size(); ++n) {
    text += state_text(separator, scene.particles[n].id, event.positions[n], event.velocities[n]);
    separator = ",";
  }
  return text + "]" + flag("boundary", event.boundary) + flag("tied", event.tied) +
         flag("unsettled", !event.settled) + "}";
}

std::string timing(exact::Kind kind, const eval::Operation& operation, const JsonValue& in,
                   const Place& place) {
  exact::Counters uncounted;
  const certified::TimingInput input{kind, eval::read_value(operation, in, place.source, place.pointer)};
  return timing_text(exact::rounded_time(input.query(), uncounted));
}

std::string drag(const eval::Operation& operation, const JsonValue& in, const Place& place) {
  const eval::Input input = eval::read_value(operation, in, place.source, place.pointer);
  const double gamma = input.values.at("gamma")[0], s = input.values.at("s")[0];
  if (!exact::drag_clock_is_reached(gamma, s)) return R"({"verdict":"never","t":null})";
  const exact::DragTime time = exact::rounded_drag_time(gamma, s);
  return fmt::format(R"({{"verdict":"reached","t":{}{}}})", quoted_number(time.t),
                     flag("unsettled", !time.settled));
}

std::string group(const JsonValue& in, const Place& place) {
  return group_text(certified::certified_group(read_group(in, place)));
}

std::string next_event(const JsonValue& in, const Place& place) {
  const Scene scene = read_next_event(in, place);
  if (certified::not_certified(scene)) {
    certified::ExactTiming certifier;
    try {
      return simulated_text(tps::next_event(scene, {Timing::certified, &certifier}));
    } catch (const InputError& error) {  // knows the scene, not where it stands
      throw InputError({{place.source, in.line, place.pointer, error.problems().front().message}});
    }
  }
  const certified::NextEventInput input = certified::next_event_input(scene);
  const auto event = certified::certified_next_event(input);
  return event ? event_text(scene, input.limits[event->limit], *event) : nothing_text(scene);
}

}  // namespace

const std::vector<std::string>& operation_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Entry& entry : catalogue()) {
      if (entry.is_answered) all.emplace_back(entry.name);
    }
    return all;
  }();
  return names;
}

std::string answer_order(const OrderInput& input) {
  exact::Counters uncounted;
  const exact::Order order = exact::time_order(input.first.query(), input.second.query(), uncounted);
  return fmt::format(R"({{"order":"{}"}})", exact::name(order));
}

std::string answer(std::string_view name, const JsonValue& in, const std::string& source,
                   const std::string& pointer) try {
  const Place place{source, pointer};
  if (name == "order") return answer_order(read_order(in, place));
  if (name == "group") return group(in, place);
  if (name == "next_event") return next_event(in, place);
  if (name == "simulate") return simulate(in, place);
  const eval::Operation& operation = *eval::find_operation(name);
  if (const auto kind = certified::timing_kind(name)) return timing(*kind, operation, in, place);
  if (operation.op == eval::Op::drag_time) return drag(operation, in, place);
  return response_text(
      certified::certified_response(operation.op, eval::read_value(operation, in, source, pointer)));
} catch (const eval::NoAnswer& why) {
  throw why.in(source, in.line, pointer);
}

}  // namespace tps::protocol
