// The input of operations that is more than a list of numbers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/text/json_document.hpp"
#include "verify/operations/group_input.hpp"
#include "verify/operations/timing_input.hpp"

namespace tps::operations {

/// The member `key` of an object. Throws InputError where it is missing or the value is no object.
const JsonValue& member(const JsonValue& object, const char* key, const Place& place);

/// Refuses keys other than those given. REQUIRES an object.
void require_keys(const JsonValue& object, const std::vector<std::string>& keys, const Place& place);

struct OrderInput {
  TimingInput first, second;
};

/// {"first":{"kind":"block","u_A":…},"second":{"kind":"tether",…}}. Throws InputError.
OrderInput read_order(const JsonValue& in, const Place& place);

/// The same from "first.kind=block", "first.u_A=0,0", … Throws InputError.
OrderInput read_order_words(const std::vector<std::string>& words);

/// {"bodies":[{"m","u","v"},…],"collisions":[{"i","j","limit":"inner","c"} or
/// {"i","j","limit":"outer","c_retract", "c_revolve","theta_revolve_deg"},…]}. Throws InputError.
GroupInput read_group(const JsonValue& in, const Place& place);

/// So many particles are half a million pairs, each asked exactly.
constexpr std::size_t kMostParticles = 1000;

/// {"scene":{…}}. Throws InputError.
Scene read_next_event(const JsonValue& in, const Place& place);

/// A reply is one line, so that a run in it has an end.
constexpr std::uint64_t kMostEvents = 1000;

struct SimulateInput {
  Scene scene;
  std::uint64_t max_events = kMostEvents;
};

/// {"scene":{…},"max_events":n}, the latter from 1 to kMostEvents, which it is where it is left out. Throws
/// InputError.
SimulateInput read_simulate(const JsonValue& in, const Place& place);

}  // namespace tps::operations
