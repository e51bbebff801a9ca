#include "tests/trace_check/rows.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/text/hexfloat.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/edits.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps::mutation {
namespace {

using Random = std::mt19937_64;

int any(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}
double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
/// A few numbers further or back.
double beside(Random& random, double x, int ulps) {
  for (int n = any(random, -ulps, ulps); n != 0; n -= n > 0 ? 1 : -1)
    x = std::nextafter(x, n > 0 ? 1e300 : -1e300);
  return x;
}

/// A pair on its row, whose first member flies at the second.
struct Row {
  double gap;    ///< between the centres
  double aside;  ///< of the first one's path
  double speed, tilt = 0;
};

Row row_of(Rows rows, Random& random) {
  constexpr double kTimes[] = {.5, 1, 1.5};
  constexpr double kSpeeds[] = {.5, 1, 2};
  const double t = kTimes[any(random, 0, 2)];
  const double v = kSpeeds[any(random, 0, 2)];
  switch (rows) {
    case Rows::near_ties: {
      const double speed = uniform(random, .5, 2);
      return {beside(random, 1 + .9 * speed, 2), 0, speed};
    }
    case Rows::grazes:
      return {uniform(random, 2, 9), beside(random, 1, 2), uniform(random, .25, 2),
              std::ldexp(any(random, -1, 1), -any(random, 54, 84))};
    case Rows::tethered:
      return {1 + v * t, any(random, 0, 1) * .25, v};
    default:
      return {1 + v * t, 0, v};
  }
}

void plan(Scene& scene, Random& random) {
  scene.impulses.push_back(
      {.at = .5 * any(random, 1, 3), .particle = any(random, 0, 3), .impulse = {0, .125, 0}});
  scene.impulses.push_back(
      {.at = .5 * any(random, 1, 3), .particle = any(random, 0, 3), .impulse = {.25, 0, 0}});
  scene.phases.push_back({.from = .5 * any(random, 1, 2),
                          .until = .5 * any(random, 3, 4),
                          .species_a = 0,
                          .species_b = 0,
                          .form = FormRule{.when = FormRule::When::never, .probability = 1},
                          .breaks = {}});
}

}  // namespace

Scene scene_of_rows(Rows rows, std::uint64_t seed) {
  Random random(seed * 6 + static_cast<std::uint64_t>(rows));
  Scene scene = testing::plain_scene(2);
  testing::block(scene, 0, 0);
  const bool pulls = rows == Rows::tethered || rows == Rows::planned;
  if (pulls) testing::tether(scene, 0, 0, 1.5, .5, FormRule::When::always);
  std::vector<std::pair<Coordinates, Coordinates>> all;
  const int count = any(random, 3, 6);
  for (int n = 0; n < count; ++n) {
    const Row row = row_of(rows, random);
    const double y = 16. * n;
    const double first = any(random, 0, 1) == 0 ? 0 : 16;
    // Passing at the limit needs the exact distance from y: rows of grazes are apart in x.
    const Coordinates a = rows == Rows::grazes ? Coordinates{64. * n - row.gap, row.aside, 0}
                                               : Coordinates{first - row.gap, y + row.aside, 0};
    const Coordinates b = rows == Rows::grazes ? Coordinates{64. * n, 0, 0} : Coordinates{first, y, 0};
    all.emplace_back(a, Coordinates{row.speed, row.tilt, 0});
    all.emplace_back(b, Coordinates{0, 0, 0});
  }
  std::ranges::shuffle(all, random);
  for (const auto& [position, velocity] : all) testing::add_particle(scene, 0, position, velocity);
  if (rows == Rows::bodies) scene.grouping = Grouping{.25};
  if (rows == Rows::planned) plan(scene, random);
  return scene;
}

Trace run_of(const Scene& scene, const Making& making, RunOptions options) {
  certified::ExactTiming certifier;
  options.scalar = *scalar_kind(making.scalar);
  options.timing = making.timing;
  options.certifier = &certifier;
  Trace trace = trace_of(testing::traced_bytes(scene, options));
  for (std::size_t n = trace.lines.size(); n-- > 0;) {
    if (is_state(trace.lines[n])) trace.lines.erase(n);
  }
  return trace;
}

namespace {

/// Multiplies a number or all numbers below it, decimal or hexadecimal ones.
void multiply(Json& value, int exponent) {
  if (value.is_string() && value != "inf") {
    HexDigits digits = *split_hex(value.get<std::string>());
    digits.exponent += exponent;
    value = join_hex(digits);
  } else if (value.is_number()) {
    value = std::ldexp(value.get<double>(), exponent);
  } else if (value.is_array() || value.is_object()) {
    for (Json& item : value) multiply(item, exponent);
  }
}

void multiply_keys(Json& object, std::initializer_list<const char*> keys, int exponent) {
  for (const char* key : keys) {
    if (object.contains(key)) multiply(object[key], exponent);
  }
}

void scale_scene(Json& scene, int length, int speed) {
  multiply_keys(scene, {"duration"}, length - speed);
  for (Json& species : scene["species"]) multiply_keys(species, {"radius"}, length);
  for (Json& pair : scene["pairs"]) {
    for (const char* law : {"blocking", "tethering"}) {
      if (pair.contains(law)) multiply_keys(pair[law], {"distance"}, length);
    }
  }
  for (Json& p : scene["particles"]) {
    multiply_keys(p, {"position"}, length);
    multiply_keys(p, {"velocity"}, speed);
  }
  if (scene.contains("grouping")) multiply_keys(scene["grouping"], {"dt_restitute"}, length - speed);
  if (scene.contains("impulses")) {
    for (Json& impulse : scene["impulses"]) {
      multiply_keys(impulse, {"at"}, length - speed);
      multiply_keys(impulse, {"impulse"}, speed);
    }
  }
  if (scene.contains("phases")) {
    for (Json& phase : scene["phases"]) multiply_keys(phase, {"from", "until"}, length - speed);
  }
}

}  // namespace

Trace in_units(const Trace& trace, int length, int speed) {
  Trace scaled = trace;
  for (std::size_t n = 0; n < scaled.lines.size(); ++n) {
    Json& line = scaled.lines.change(n);
    if (line.contains("scene")) scale_scene(line["scene"], length, speed);
    multiply_keys(line, {"t", "dt"}, length - speed);
    multiply_keys(line, {"dp", "dp_stored"}, speed);
    for (const char* when : {"pre", "post"}) {
      if (!line.contains(when)) continue;
      for (Json& state : line[when]) {
        multiply_keys(state, {"position"}, length);
        multiply_keys(state, {"velocity"}, speed);
      }
    }
  }
  return scaled;
}

Trace ended_behind(const Trace& trace, std::size_t events, const char* reason, const std::string& t) {
  Trace cut = trace;
  const Json end = cut.lines.back();
  cut.lines.keep_first(events == 0 ? 1 : event_lines(trace)[events - 1] + 1);
  cut.lines.push_back(end);
  cut.lines.change_last()["end"] = reason;
  cut.lines.change_last()["t"] = t;
  settle(cut);
  return cut;
}

}  // namespace tps::mutation
