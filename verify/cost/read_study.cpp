#include <fmt/format.h>

#include <algorithm>

#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/schema_validator.hpp"
#include "reference/text/text_file.hpp"
#include "verify/cost/report.hpp"

namespace tps::cost {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;

bool names(const Json& list, const Json& name) {
  return std::any_of(list.begin(), list.end(), [&](const Json& each) { return each.at("name") == name; });
}

/// Strata are read with what their names and figures refer to.
void require_parts(const Json& study, const std::string& file) {
  InputProblems problems(file);
  for (const char* key : {"settings", "formulas", "variants"}) {
    if (!study.contains(key)) problems.add(0, "", fmt::format("key \"{}\" is missing; strata need it", key));
  }
  problems.throw_if_any();
}

/// What a schema cannot say: every cell and bin is of a variant that is listed, every variant of a formula.
void require_names(const Json& study, const std::string& file) {
  InputProblems problems(file);
  const auto require = [&](const Json& list, const Json& name, const std::string& place, const char* key) {
    if (names(list, name)) return;
    problems.add(0, place, shown(name) + " is not among the names of /" + key);
  };
  const Json& variants = study.at("variants");
  for (std::size_t k = 0; k < variants.size(); ++k) {
    require(study.at("formulas"), variants[k].at("formula"), "/variants/" + std::to_string(k) + "/formula",
            "formulas");
  }
  const Json& strata = study.at("strata");
  for (std::size_t s = 0; s < strata.size(); ++s) {
    for (const char* list : {"cells", "by_tangency", "by_condition"}) {
      for (std::size_t k = 0; k < strata[s].at(list).size(); ++k) {
        require(variants, strata[s].at(list)[k].at("variant"),
                "/strata/" + std::to_string(s) + "/" + list + "/" + std::to_string(k) + "/variant",
                "variants");
      }
    }
  }
  problems.throw_if_any();
}

}  // namespace

Json read_study(const std::string& path) {
  const std::string text = read_text_file(path, kMostBytes, "a study of tps cost is far smaller");
  const std::string name = display_name(path);
  const JsonDocument document = parse_json(text, name);
  InputProblems problems = document.problems;
  embedded_schema("cost").validate(document.root, problems);
  problems.throw_if_any();
  Json study = parse_plain_json(text, name);
  if (study.contains("strata")) {
    require_parts(study, name);
    require_names(study, name);
  }
  return study;
}

}  // namespace tps::cost
