#include "properties/runs/reversal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "reference/scalars.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/trace/state_data.hpp"

namespace tps::properties::runs {
namespace {

/// Place and velocity of each particle at the end, component by component.
template <typename Scalar>
struct Coordinate {
  Scalar position, velocity;
};

/// Numbers in [−1, 1) that follow no pattern of a scene: multiples of the golden ratio, without their whole
/// parts.
Real spread(std::size_t n) {
  const Real multiple = Real(n + 1) * 0.61803398874989484820L;
  return 2 * (multiple - std::floor(multiple)) - 1;
}

StateData last_state(const RunTrace& run) {
  const auto found = std::find_if(run.lines.rbegin(), run.lines.rend(),
                                  [](const std::string& line) { return line.starts_with("{\"state\":"); });
  if (found == run.lines.rend()) throw std::runtime_error("the trace has no full state");
  return read_state(*found);
}

template <typename Scalar>
std::vector<Coordinate<Scalar>> coordinates_at(const StateData& state, double t) {
  const auto number = [](const Hex& text) { return from_hex<Scalar>(text).value(); };
  std::vector<Coordinate<Scalar>> all;
  for (const StateData::Particle& p : state.particles) {
    const Scalar flight = (Scalar(t) - number(p.clock[0])) - number(p.clock[1]);
    for (std::size_t k = 0; k < p.position.size(); ++k) {
      const Scalar v = number(p.velocity[k]);
      all.push_back({number(p.position[k]) + v * flight, v});
    }
  }
  return all;
}

template <typename Scalar>
std::string turned(const RunTrace& run, double t, Real shift) {
  StateData state = last_state(run);
  const std::vector<Coordinate<Scalar>> at_end = coordinates_at<Scalar>(state, t);
  std::size_t next = 0;
  for (StateData::Particle& p : state.particles) {
    p.clock = {"0x0p+0", "0x0p+0"};
    for (std::size_t k = 0; k < p.position.size(); ++k, ++next) {
      p.position[k] = to_hex(Scalar(at_end[next].position + Scalar(shift * spread(next))));
      p.velocity[k] = to_hex(Scalar(-at_end[next].velocity));
    }
  }
  state.k = 0;
  state.final = false;
  state.now = state.last_event = {"0x0p+0", "0x0p+0"};
  state.progress_event = 0;
  state.responded.clear();
  std::erase_if(state.counts, [](const auto& count) { return !count.first.starts_with('#'); });
  for (const char* counter : {"#noise", "#zero_impulse"}) state.counts[counter] = 0;
  return run.lines.front() + "\n" + write_state(state, "0x0p+0") + "\n";
}

}  // namespace

std::string turned_round(const RunTrace& run, const Scene& scene, const std::string& scalar, Real shift) {
  if (scalar == "double") return turned<double>(run, scene.duration, shift);
  if (scalar == "mp50") return turned<Mp50>(run, scene.duration, shift);
  if (scalar == "mp100") return turned<Mp100>(run, scene.duration, shift);
  throw std::invalid_argument("runs in " + scalar + " cannot be turned round; double, mp50 and mp100 can");
}

Real parted(const RunTrace& a, const RunTrace& b, const Scene& scene, Real sign) {
  const auto first = coordinates_at<Mp100>(last_state(a), scene.duration);
  const auto second = coordinates_at<Mp100>(last_state(b), scene.duration);
  Mp100 largest = 0;
  for (std::size_t n = 0; n < first.size(); ++n) {
    largest = std::max({largest, Mp100(abs(first[n].position - second[n].position)),
                        Mp100(abs(first[n].velocity - Mp100(sign) * second[n].velocity))});
  }
  return static_cast<Real>(largest);
}

Real away_from_start(const RunTrace& run, const Scene& scene) {
  const auto at_end = coordinates_at<Mp100>(last_state(run), scene.duration);
  Mp100 largest = 0;
  std::size_t next = 0;
  for (const Particle& p : scene.particles) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k, ++next) {
      largest = std::max({largest, Mp100(abs(at_end[next].position - Mp100(p.position[k]))),
                          Mp100(abs(at_end[next].velocity + Mp100(p.velocity[k])))});
    }
  }
  return static_cast<Real>(largest);
}

Real roundoff_of(const std::string& scalar) {
  if (scalar == "double") return std::ldexp(Real(1), -std::numeric_limits<double>::digits);
  if (scalar == "mp50") return std::ldexp(Real(1), -std::numeric_limits<Mp50>::digits);
  if (scalar == "mp100") return std::ldexp(Real(1), -std::numeric_limits<Mp100>::digits);
  return 0;
}

}  // namespace tps::properties::runs
