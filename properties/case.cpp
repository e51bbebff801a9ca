#include "properties/case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::properties {
namespace {

Json number_json(double x) {
  return to_hex<double>(x);
}

double read_number(const Json& value, const std::string& key) {
  if (value == "inf") return HUGE_VAL;
  if (value.is_string()) {
    const HexFloat number = parse_hex_float(value.get_ref<const std::string&>());
    if (number.verdict == HexFloat::Verdict::exact) return number.value;
  }
  throw std::invalid_argument(fmt::format(
      "{} has {}; a number is a hexadecimal float or \"inf\", in a string", key, tps::shown(value)));
}

/// "second.u_A" is a u_A.
std::string_view without_prefix(std::string_view key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

/// In the plane a case's spin is its first number.
bool is_spin_in_the_plane(std::string_view key, int dimension) {
  return dimension == 2 && without_prefix(key).starts_with("spin");
}

std::string number_text(double x) {
  const std::string decimal = fmt::format("{}", x);
  return decimal.size() <= 8 ? decimal : to_hex<double>(x);
}

}  // namespace

Vec3 Case::vector(const std::string& key) const {
  const std::vector<double>& x = numbers.at(key);
  return {x.at(0), x.at(1), x.size() > 2 ? x[2] : 0.0};
}

void Case::set(const std::string& key, const Vec3& x) {
  numbers[key].assign(x.begin(), x.begin() + dimension);
}

void Case::set(const PairState& pair) {
  set("u_A", pair.u_A);
  set("u_B", pair.u_B);
  set("v_A", pair.v_A);
  set("v_B", pair.v_B);
}

void Case::set(const Masses& m) {
  set("m_A", m.A);
  set("m_B", m.B);
}

Kind kind_of(std::string_view key) {
  key = without_prefix(key);
  if (key == "L" || key == "L_larger" || key.starts_with("R_") || key == "gamma") return Kind::length;
  if (key == "s" || key == "mu") return Kind::not_negative;
  if (key == "beta0") return Kind::signed_coefficient;
  if (key.starts_with("m_") || key == "m") return Kind::mass;
  if (key.starts_with("theta")) return Kind::angle;
  if (key == "c" || key.starts_with("c_")) return Kind::coefficient;
  if (key.starts_with("power")) return Kind::exponent;
  if (key == "i" || key == "j" || key == "axes" || key == "kind") return Kind::index;
  return Kind::component;
}

bool is_allowed(Kind kind, double x) {
  constexpr double kLargestIndex = 1000;
  if (!std::isfinite(x)) return kind == Kind::mass && x > 0;
  switch (kind) {
    case Kind::length:
    case Kind::mass:
      return x > 0;
    case Kind::coefficient:
      return x >= 0 && x <= 1;
    case Kind::signed_coefficient:
      return std::fabs(x) <= 1;
    case Kind::not_negative:
      return x >= 0;
    case Kind::angle:
      return x >= 1 && x <= 89;
    case Kind::exponent:
      return x == std::trunc(x) && std::fabs(x) <= kLargestIndex;
    case Kind::index:
      return x == std::trunc(x) && x >= 0 && x <= kLargestIndex;
    default:
      return true;
  }
}

bool is_vector(std::string_view key) {
  key = without_prefix(key);
  return kind_of(key) == Kind::component && key != "dt" && key != "u" && key != "v";
}

Json case_json(const Case& c) {
  Json numbers = Json::object();
  for (const auto& [key, values] : c.numbers) {
    Json list = Json::array();
    for (const double x : values) list.push_back(number_json(x));
    numbers[key] = list;
  }
  return {{"dimension", c.dimension}, {"hazard", c.hazard}, {"numbers", numbers}};
}

Case read_case(const Json& json) {
  try {
    const Json& dimension = json.at("dimension");  // compared as it stands: it may be no int at all
    if (dimension != 2 && dimension != 3)
      throw std::invalid_argument(fmt::format("dimension is {}; allowed: 2, 3", tps::shown(dimension)));
    Case c{dimension == 2 ? 2 : 3, json.at("hazard").get<std::string>()};
    for (const auto& [key, list] : json.at("numbers").items()) {
      for (const Json& x : list) {
        c.numbers[key].push_back(read_number(x, key));
        if (!is_allowed(kind_of(key), c.numbers[key].back()))
          throw std::invalid_argument(
              fmt::format("{} has {}, which is outside its range", key, tps::shown(x)));
      }
      if (is_vector(key) && static_cast<int>(c.numbers[key].size()) != c.dimension) {
        throw std::invalid_argument(
            fmt::format("{} has {} components in {} dimensions", key, c.numbers[key].size(), c.dimension));
      }
    }
    return c;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(fmt::format("not a case: {}", error.what()));
  }
}

std::ostream& operator<<(std::ostream& out, const Case& c) {
  out << c.hazard << ", " << c.dimension << "-D";
  for (const auto& [key, values] : c.numbers) {
    out << ", " << key << " = ";
    const std::size_t shown = is_spin_in_the_plane(key, c.dimension) ? 1 : values.size();
    const bool list = shown != 1;
    if (list) out << '(';
    for (std::size_t k = 0; k < shown; ++k) out << (k > 0 ? ", " : "") << number_text(values[k]);
    if (list) out << ')';
  }
  return out;
}

}  // namespace tps::properties
