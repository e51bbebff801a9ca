#include "verify/trace_check/witness.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "reference/text/plain_json.hpp"
#include "verify/vectors/generate.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::check {
namespace {

using vectors::Json;

/// What a backward stable evaluation of the operation reaches (docs/vectors.md): times, where they have a
/// condition number, and responses by it.
Json accepted(const Json& answer) {
  Json classes = Json::array({"R"});
  if (answer.contains("cond") && !answer["cond"].is_null()) classes.push_back("K(16)");
  return classes;
}

std::string case_of(const CheckReport& report, const Finding& f) {
  const std::string op(operations::name(f.replay->op));
  const Json in = Json::parse(f.replay->in);
  const Json header{{"schema", "vectors"},
                    {"version", vectors::kVectorsVersion},
                    {"semantics", 1},
                    {"op", op},
                    {"stratum", "witness"},
                    {"why", fmt::format("rule {} at line {} of {}", name(f.rule), f.line, report.file)},
                    {"generator", "tps check"},
                    {"seed", 0},
                    {"first", 0},
                    {"count", 1}};
  Json line{{"id", fmt::format("{}.witness.{}.{:05}", op, name(f.rule), f.line)}, {"rev", 1}, {"in", in}};
  const Json answer = vectors::known_answer(f.replay->op, in);
  line.update(answer);
  line["tags"] = Json::array({"witness", name(f.rule)});
  line["level"] = 1;
  line["accept"] = accepted(answer);
  line["why"] = f.message;
  return json_text(header) + "\n" + json_text(line) + "\n";
}

}  // namespace

std::string witness_cases(const CheckReport& report) {
  std::string text;
  std::set<Rule> done;
  for (const Finding& f : report.findings) {
    if (f.outcome != Outcome::violated || !f.replay || done.count(f.rule) != 0) continue;
    try {
      text += case_of(report, f);
      done.insert(f.rule);
    } catch (const std::exception&) {
      // Numbers that a known answer cannot have, such as an underflow to zero of a wide scalar's: the next
      // one may.
    }
  }
  return text;
}

}  // namespace tps::check
