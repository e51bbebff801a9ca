// One generated case of a law: doubles by name, whatever the law. Shrinking, files and messages need no more.
#pragma once

#include <array>
#include <iosfwd>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tps::properties {

using Json = nlohmann::ordered_json;

/// A vector of the plane has z = 0.
using Vec3 = std::array<double, 3>;

/// Two particles, as the operations take them.
struct PairState {
  Vec3 u_A{}, u_B{}, v_A{}, v_B{};

  friend bool operator==(const PairState&, const PairState&) = default;
};

/// Two masses of which at most one is infinite.
struct Masses {
  double A, B;
};

/// Numbers by the keys of the interface (u_A, m_B, c_revolve, …) and by keys of a law's own.
struct Case {
  int dimension = 3;
  std::string hazard = "general";  ///< what the generator aimed at
  std::map<std::string, std::vector<double>> numbers = {};

  double number(const std::string& key) const { return numbers.at(key).at(0); }
  int integer(const std::string& key) const { return static_cast<int>(number(key)); }
  Vec3 vector(const std::string& key) const;
  PairState pair() const { return {vector("u_A"), vector("u_B"), vector("v_A"), vector("v_B")}; }
  Masses masses() const { return {number("m_A"), number("m_B")}; }

  void set(const std::string& key, double x) { numbers[key] = {x}; }
  void set(const std::string& key, const Vec3& x);
  void set(const PairState& pair);
  void set(const Masses& m);

  friend bool operator==(const Case&, const Case&) = default;
};

/// What a number of a case may be, by its key.
enum class Kind {
  component,
  length,
  mass,
  coefficient,
  signed_coefficient,
  not_negative,
  angle,
  exponent,
  index
};
Kind kind_of(std::string_view key);
/// Whether cases may have that number: lengths, rates and masses above 0, masses up to ∞, coefficients in [0,
/// 1] or, signed, in [−1, 1], angles in [1°, 89°], whole exponents and indices; everything else finite.
bool is_allowed(Kind kind, double x);
/// Whether the key holds one vector, with as many components as the case has dimensions.
bool is_vector(std::string_view key);

/// {"dimension":2,"hazard":"graze","numbers":{"u_A":["0x0p+0",…],…}} and back, exactly. Reading throws
/// std::invalid_argument for anything else.
Json case_json(const Case& c);
Case read_case(const Json& json);

/// For people: decimals where they are short, hexadecimal floats elsewhere.
std::ostream& operator<<(std::ostream& out, const Case& c);

}  // namespace tps::properties
