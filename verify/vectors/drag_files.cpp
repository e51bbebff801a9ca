// The strata of drag_time: t = −ln(1 − γs)/γ.
#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace drag_files {
namespace {

constexpr int kCommitted = 24;

struct Clock {
  double gamma, s;
};

Clock plain(Random& random) {
  const double gamma = random.uniform(0.1, 2);
  return {gamma, random.uniform(0, 1) / gamma};
}

/// γs down to 2^-1000: t is s but for the last bits, or s to the last.
Clock early(Random& random) {
  const double gamma = random.uniform(0.5, 2);
  const double s = random.uniform(0.5, 1);
  return {gamma, std::ldexp(s, -random.integer(1, 1000))};
}

/// γs = 2^-k and a bit: what is beyond s in t is a 2^-(k+1)th of it, and no double takes it for nothing.
Clock small(Random& random) {
  const double gamma = random.uniform(0.5, 2);
  const double s = random.uniform(0.5, 1);
  return {gamma, std::ldexp(s, -random.integer(2, 45))};
}

/// 1 − γs down to rounding: the logarithm has lost nearly all of z's digits.
Clock late(Random& random) {
  const double gamma = std::ldexp(1.0, random.integer(-3, 3));
  const double rest = random.uniform(0.5, 1);
  return {gamma, (1 - std::ldexp(rest, -random.integer(5, 52))) / gamma};
}

/// Doubles around 1/γ, on both sides of the end of time.
Clock end(Random& random) {
  const double gamma = random.uniform(0.1, 10);
  double s = 1 / gamma;
  const double side = random.coin() ? HUGE_VAL : 0;
  for (int n = random.integer(0, 4); n > 0; --n) s = std::nextafter(s, side);
  return {gamma, s};
}

/// γ a power of two, s small multiples of one: z is a short number.
Clock short_numbers(Random& random) {
  const double gamma = std::ldexp(1.0, random.integer(-4, 4));
  return {gamma, random.integer(0, 20) / (16 * gamma)};
}

Clock any_scale(Random& random) {
  const Clock clock = plain(random);
  const int power = random.integer(-900, 900);
  return {std::ldexp(clock.gamma, power), std::ldexp(clock.s, -power)};
}

Clock float32(Random& random) {
  const Clock clock = plain(random);
  return {static_cast<float>(clock.gamma), static_cast<float>(clock.s)};
}

struct Family {
  const char* name;
  const char* why;
  Clock (*clock)(Random&);
};

constexpr Family families[] = {
    {"plain", "gamma s between 0 and 1", plain},
    {"early", "gamma s down to 2^-1000: t is s but for its last bits, or to the last", early},
    {"late", "1 - gamma s down to 2^-52: a relative error of gamma s is magnified", late},
    {"end", "s one of the doubles around 1/gamma, where time ends", end},
    {"short", "gamma s in sixteenths, 0 and 1 among them", short_numbers},
    {"any_scale", "gamma times 2^k, s times 2^-k", any_scale},
    {"float32", "both numbers exact in single precision", float32},
    {"small", "gamma s = 2^-k, k from 2 to 45: t is beyond s by half of that", small},
};

}  // namespace
}  // namespace drag_files

void add_drag_strata(std::vector<Stratum>& strata) {
  for (const drag_files::Family& family : drag_files::families) {
    strata.push_back({Op::drag_time, family.name, family.why, drag_files::kCommitted,
                      [family](Random& random, std::uint64_t) -> Problem {
                        const drag_files::Clock clock = family.clock(random);
                        return {{{"gamma", hex(clock.gamma)}, {"s", hex(clock.s)}}, {family.name}};
                      }});
  }
}

}  // namespace tps::vectors
