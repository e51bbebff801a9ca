// Values in the JSON of a line: numbers, times, vectors, particles. Included by read_line_impl.hpp only
// (simdjson is a heavy header).
#pragma once

#include <fmt/format.h>
#include <simdjson.h>

#include <charconv>
#include <type_traits>
#include <unordered_map>

#include "reference/scene/scene.hpp"
#include "reference/text/nearest_name.hpp"
#include "verify/trace_check/line.hpp"
#include "verify/trace_check/text_number.hpp"

namespace tps::check {

namespace dom = simdjson::dom;

/// Where a value stands in its line, as a JSON pointer; spelt out only when something is wrong there.
struct Pointer {
  const Pointer* above = nullptr;  ///< null: the line itself
  std::string_view key = {};

  std::string text() const {
    return above == nullptr ? std::string() : fmt::format("{}/{}", above->text(), key);
  }
};
inline constexpr Pointer kLine;
inline constexpr Pointer kPre{&kLine, "pre"};
inline constexpr Pointer kPost{&kLine, "post"};

[[noreturn]] inline void problem(const Pointer& at, const std::string& message) {
  throw LineProblem(at.text(), message);
}
/// About a member of the line.
[[noreturn]] inline void problem(std::string_view key, const std::string& message) {
  problem(Pointer{&kLine, key}, message);
}

[[noreturn]] inline void unknown_key(const Pointer& at, std::string_view key,
                                     const std::vector<std::string>& known) {
  problem(at, "is not known here" + did_you_mean(key, known));
}

/// Every function throws LineProblem with the pointer `at` where the value is not what it should be.
template <typename Number>
class LineValues {
 public:
  LineValues(const Scene& scene, bool minimal, int digits)
      : scene_(scene), minimal_(minimal), digits_(digits) {
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
      index_of_.emplace(scene.particles[n].id, static_cast<int>(n));
      ids_.push_back(scene.particles[n].id);
    }
  }

  static std::string_view text(dom::element value, const Pointer& at) {
    std::string_view result;
    if (value.get(result) != simdjson::SUCCESS) {
      problem(at, fmt::format("is {}, not a string; exact numbers are in strings, too: \"0x1.8p+1\"",
                              std::string(simdjson::minify(value)).substr(0, 60)));
    }
    return result;
  }

  static std::uint64_t count(dom::element value, const Pointer& at) {
    std::uint64_t result = 0;
    if (value.get(result) != simdjson::SUCCESS) problem(at, "is not a number of events: 0, 1, 2, …");
    return result;
  }

  Number number(dom::element value, const Pointer& at) const {
    double plain = 0;
    std::string_view hex;
    if (minimal_ && value.get(plain) == simdjson::SUCCESS) return Number(plain);
    if (value.get(hex) != simdjson::SUCCESS) problem(at, kNumberForm);
    const std::optional<Number> result = number_of<Number>(hex);
    if (!result || !fits(hex, *result)) problem(at, fmt::format("\"{}\" {}", hex.substr(0, 60), kNumberForm));
    if (!(*result - *result == Number(0)))
      problem(at, "is infinite; positions, velocities and impulses are finite");
    return *result;
  }

  /// The finite number of the trace's scalar that a text spells, if it is one.
  bool number_if_any(std::string_view hex, Number& number) const {
    const std::optional<Number> result = number_of<Number>(hex);
    if (!result || !fits(hex, *result) || !(*result - *result == Number(0))) return false;
    number = *result;
    return true;
  }
  /// The time that a text spells on the clock that the lines of a scene without drag have.
  bool instant_if_any(std::string_view hex, Instant<Number>& t) const {
    if (has_drag()) return false;
    const std::optional<Instant<Number>> result = instant_of<Number>(hex, scene_.start_time);
    if (!result || !(result->hi - result->hi == Number(0))) return false;
    t = *result;
    return true;
  }

  bool fits(double value) const {
    return digits_ >= 53 || static_cast<double>(static_cast<float>(value)) == value;
  }
  bool fits(std::string_view hex, const Number& value) const {
    if constexpr (std::is_same_v<Number, double>) {
      return fits(value);
    } else {
      const std::optional<HexDigits> digits = split_hex(hex);  // none in "inf"
      return !digits || significant_bits(*digits) <= digits_;
    }
  }

  Instant<Number> instant(dom::element value, const Pointer& at) const {
    return instant(value, at, scene_.start_time);
  }
  /// The clock of a scene with drag, which counts from the start.
  Instant<Number> clock(dom::element value, const Pointer& at) const { return instant(value, at, 0); }

  Instant<Number> instant(dom::element value, const Pointer& at, double start_time) const {
    double plain = 0;
    if (minimal_ && value.get(plain) == simdjson::SUCCESS) {
      const Number t = Number(plain) - Number(start_time);
      if (!(t - t == Number(0))) problem(at, "is too long after the start for a number of the check");
      return {t, Number(0)};
    }
    const std::string_view hex = text(value, at);
    const std::optional<Instant<Number>> result = instant_of<Number>(hex, start_time);
    if (!result || !(result->hi - result->hi == Number(0))) {
      problem(at, fmt::format("\"{}\" {}", hex.substr(0, 60), kNumberForm));
    }
    return *result;
  }

  /// A time of a scene with drag: a double, whatever the scalar.
  double time(dom::element value, const Pointer& at) const {
    double plain = 0;
    if (minimal_ && value.get(plain) == simdjson::SUCCESS) return plain;
    const std::optional<double> result = number_of<double>(text(value, at));
    if (!result || !std::isfinite(*result))
      problem(at, "is no double, which the time of a scene with \"drag\" is");
    return *result;
  }

  Vec<Number> vector(dom::element value, const Pointer& at) const {
    dom::array components;
    const auto dimension = static_cast<std::size_t>(scene_.dimension);
    if (value.get(components) != simdjson::SUCCESS || components.size() != dimension) {
      problem(at, fmt::format("is not a list of {} numbers, the dimension of the scene", dimension));
    }
    Vec<Number> result;
    std::size_t n = 0;
    for (const dom::element component : components) {
      result[n] = number(component, at);
      ++n;
    }
    return result;
  }

  /// One number in the plane, which is along z; three in space.
  Vec<Number> spin(dom::element value, const Pointer& at) const {
    dom::array components;
    const std::size_t size = scene_.dimension == 2 ? 1 : 3;
    if (value.get(components) != simdjson::SUCCESS || components.size() != size) {
      problem(at,
              fmt::format("is not a list of {} numbers, a spin in {} dimensions", size, scene_.dimension));
    }
    Vec<Number> result;
    std::size_t n = size == 1 ? 2 : 0;
    for (const dom::element component : components) result[n++] = number(component, at);
    return result;
  }

  int particle(std::int64_t id, const Pointer& at) const {
    int index = -1;
    if (id < 0 || !particle_if_any(static_cast<std::uint64_t>(id), index))
      problem(at, fmt::format("names particle {}, which the scene does not have", id));
    return index;
  }
  /// Most scenes count their particles from 0.
  bool particle_if_any(std::uint64_t id, int& index) const {
    if (id < ids_.size() && ids_[id] == static_cast<std::int32_t>(id)) {
      index = static_cast<int>(id);
      return true;
    }
    const auto found = id > 2147483647 ? index_of_.end() : index_of_.find(static_cast<std::int32_t>(id));
    if (found == index_of_.end()) return false;
    index = found->second;
    return true;
  }
  int particle(dom::element value, const Pointer& at) const {
    std::int64_t id = 0;
    if (value.get(id) != simdjson::SUCCESS) problem(at, "is not the id of a particle");
    return particle(id, at);
  }
  int particle_named(std::string_view key, const Pointer& at) const {
    std::int64_t id = -1;
    const auto [last, error] = std::from_chars(key.data(), key.data() + key.size(), id);
    if (error != std::errc() || last != key.data() + key.size() || key != std::to_string(id)) {
      problem(at, fmt::format("\"{}\" is not the id of a particle", key.substr(0, 60)));
    }
    return particle(id, at);
  }

  bool minimal() const { return minimal_; }
  int dimension() const { return scene_.dimension; }
  bool has_drag() const { return scene_.drag.has_value(); }

 private:
  static constexpr const char* kNumberForm =
      "is not an exact number of the trace's scalar: a hexadecimal float in a string, \"0x1.8p+1\"";

  const Scene& scene_;
  bool minimal_;
  int digits_;
  std::unordered_map<std::int32_t, int> index_of_;
  std::vector<std::int32_t> ids_;  ///< of particles
};

}  // namespace tps::check
