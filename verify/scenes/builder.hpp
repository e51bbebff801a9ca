// A parametrised scene as `tps scene NAME --option value …` offers it.
//
// A scene of the catalogue is a plain struct of parameters, a pure function from it to a Scene, and a table
// that says what each parameter is called, may be, and means. The table is the only place where text becomes
// numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// The values a parameter may have: least <= x <= most, or least < x <= most.
struct Range {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  bool least_allowed = true;
};

/// least <= x <= most
constexpr Range from_to(double least, double most) {
  return {least, most, true};
}

/// least < x <= most
constexpr Range above(double least, double most = std::numeric_limits<double>::infinity()) {
  return {least, most, false};
}

/// least < x < ∞
constexpr Range finite_above(double least) {
  return above(least, std::numeric_limits<double>::max());
}

/// One line of a scene's table: the parameter `member` of Params is the option `--name`.
template <typename Params>
struct Field {
  const char* name;
  std::variant<int Params::*, double Params::*, std::uint64_t Params::*> member;
  Range range;
  const char* meaning;
};

/// An option as help texts show it.
struct BuilderOption {
  std::string name;           ///< without the dashes
  std::string default_value;  ///< as one would type it
  std::string range;          ///< e.g. "an integer from 1 to 100"
  std::string meaning;
};

/// Texts of options by name; those not given have their defaults.
using OptionValues = std::map<std::string, std::string>;

/// A parametrised scene.
struct SceneBuilder {
  std::string name;
  std::string summary;  ///< one line
  std::vector<BuilderOption> options;
  /// The scene. Throws std::invalid_argument that names the option, its value and what is allowed.
  std::function<Scene(const OptionValues&)> build;
};

/// The value that `text` spells. Numbers as in files: decimal, hexadecimal float ("0x1p-3"), "inf".
/// Throws std::invalid_argument that names `option`, the text and the range.
double parse_real(const std::string& option, const std::string& text, Range range);
int parse_integer(const std::string& option, const std::string& text, Range range);
std::uint64_t parse_seed(const std::string& option, const std::string& text);

/// A value and a range in the words of help texts.
std::string describe(double value);
std::string describe(Range range, bool integer);

/// Refuses names that no option of `builder` has, and says which it has.
void check_names(const SceneBuilder& builder, const OptionValues& values);

/// Sets the parameter of `field` from a text.
template <typename Params>
void set(Params& params, const Field<Params>& field, const std::string& text) {
  if (const auto* real = std::get_if<double Params::*>(&field.member)) {
    params.*(*real) = parse_real(field.name, text, field.range);
  } else if (const auto* integer = std::get_if<int Params::*>(&field.member)) {
    params.*(*integer) = parse_integer(field.name, text, field.range);
  } else {
    params.*std::get<std::uint64_t Params::*>(field.member) = parse_seed(field.name, text);
  }
}

/// What help texts show of `field`.
template <typename Params>
BuilderOption describe(const Field<Params>& field) {
  static constexpr Params defaults{};
  if (const auto* real = std::get_if<double Params::*>(&field.member)) {
    return {field.name, describe(defaults.*(*real)), describe(field.range, false), field.meaning};
  }
  if (const auto* integer = std::get_if<int Params::*>(&field.member)) {
    return {field.name, std::to_string(defaults.*(*integer)), describe(field.range, true), field.meaning};
  }
  return {field.name, std::to_string(defaults.*std::get<std::uint64_t Params::*>(field.member)),
          "an integer from 0 to 2^64 - 1", field.meaning};
}

/// Assembles a parametrised scene of its table and its function.
template <typename Params>
SceneBuilder make_builder(std::string name, std::string summary, std::vector<Field<Params>> fields,
                          Scene (*scene_of)(const Params&)) {
  SceneBuilder builder{std::move(name), std::move(summary), {}, {}};
  for (const Field<Params>& field : fields) builder.options.push_back(describe(field));
  builder.build = [fields = std::move(fields), scene_of, known = builder](const OptionValues& values) {
    check_names(known, values);
    Params params;
    for (const Field<Params>& field : fields) {
      if (const auto given = values.find(field.name); given != values.end())
        set(params, field, given->second);
    }
    return scene_of(params);
  };
  return builder;
}

}  // namespace tps
