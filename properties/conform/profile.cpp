#include "properties/conform/profile.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reference/text/input_error.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::properties::conform {
namespace {

Profile failing(std::string name, std::initializer_list<Class> classes, std::optional<int> bits = {}) {
  Profile profile{std::move(name), {}, bits};
  for (const Class each : classes) profile.fails[index_of(each)] = true;
  return profile;
}

const std::vector<Profile>& built_in() {
  static const std::vector<Profile> profiles{
      failing("default", {Class::refused, Class::wrong}),
      failing("certified",
              {Class::rounding, Class::not_bitwise, Class::other_reading, Class::beyond, Class::worse,
               Class::refused, Class::wrong},
              53),
      failing("double-stable", {Class::worse, Class::refused, Class::wrong}, 53),
      failing("double-paper", {Class::refused, Class::wrong}, 53),
      failing("float", {Class::refused, Class::wrong}, 24)};
  return profiles;
}

/// Throws InputError at a place of the file.
[[noreturn]] void refuse(const std::string& file, const std::string& pointer, const std::string& message) {
  throw InputError({{file, 0, pointer, message}});
}

Class class_in(const std::string& file, const nlohmann::ordered_json& value, std::size_t n) {
  const auto found = value.is_string() ? class_named(value.get_ref<const std::string&>()) : std::nullopt;
  if (found) return *found;
  std::vector<std::string_view> names;
  for (const ClassFacts& facts : kClassFacts) names.push_back(facts.name);
  refuse(file, fmt::format("/fails/{}", n),
         fmt::format("{} is no class; there are {}", tps::shown(value), fmt::join(names, ", ")));
}

Profile read_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    refuse(file, "",
           fmt::format("is no profile and cannot be read as a file; there are {}",
                       fmt::join(profile_names(), ", ")));
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto document = parse_plain_json(text, file);
  if (!document.is_object() || document.value("conform_profile", nlohmann::ordered_json()) != 1)
    refuse(file, "", R"(is no profile: {"conform_profile":1,"name":…,"fails":["WRONG",…]})");
  Profile profile;
  for (const auto& [key, value] : document.items()) {
    if (key == "conform_profile") continue;
    if (key == "name" && value.is_string()) {
      profile.name = value.get<std::string>();
    } else if (key == "bits" && value.is_number_integer() && value >= 8 && value <= 400) {
      profile.bits = value.get<int>();
    } else if (key == "fails" && value.is_array()) {
      for (std::size_t n = 0; n < value.size(); ++n)
        profile.fails[index_of(class_in(file, value[n], n))] = true;
    } else {
      refuse(file, "/" + escape_pointer_key(key),
             "is no key of a profile, or not what it takes: name (words), fails (a list of classes), bits (8 "
             "to 400)");
    }
  }
  if (profile.name.empty()) refuse(file, "/name", "is missing; reports call the profile by it");
  return profile;
}

}  // namespace

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  for (const Profile& profile : built_in()) names.push_back(profile.name);
  return names;
}

bool is_built_in(const std::string& profile) {
  return std::any_of(built_in().begin(), built_in().end(),
                     [&](const Profile& each) { return each.name == profile; });
}

Profile read_profile(const std::string& name_or_file) {
  for (const Profile& profile : built_in()) {
    if (profile.name == name_or_file) return profile;
  }
  return read_file(name_or_file);
}

}  // namespace tps::properties::conform
