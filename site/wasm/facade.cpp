#include "site/wasm/facade.hpp"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/operations/compound_input.hpp"
#include "verify/operations/evaluate.hpp"
#include "verify/scenes/registry.hpp"
#include "verify/vectors/generate.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::web {
namespace {

using Json = nlohmann::ordered_json;
using operations::Op;
using operations::Operation;

const std::string kSource = "the request";

const JsonValue& member(const JsonValue& request, const char* key) {
  const JsonValue* value = request.find(key);
  if (value == nullptr) throw std::invalid_argument(std::string("the request has no \"") + key + "\"");
  return *value;
}

const std::string& text(const JsonValue& request, const char* key) {
  const std::string* value = member(request, key).string();
  if (value == nullptr) throw std::invalid_argument(std::string("\"") + key + "\" is not a string");
  return *value;
}

std::optional<double> number(const JsonValue& request, const char* key) {
  const JsonValue* value = request.find(key);
  if (value == nullptr || value->number() == nullptr) return std::nullopt;
  return value->number()->value;
}

Json operations_json() {
  Json list = Json::array();
  for (const Operation& operation : operations::catalogue()) {
    if (!operations::is_of_numbers(operation)) continue;
    list.push_back({{"name", operation.name},
                    {"equation", operation.rule},
                    {"what", operation.what},
                    {"keys", operation.keys}});
  }
  return {{"operations", list}};
}

Json quantities_json(const std::vector<operations::Quantity>& quantities) {
  Json list = Json::array();
  for (const operations::Quantity& q : quantities) {
    Json decimal = Json::array(), hex = Json::array();
    for (const operations::Number& n : q.numbers) {
      decimal.push_back(n.decimal);
      hex.push_back(n.hex);
    }
    list.push_back({{"key", q.key},
                    {"symbol", q.symbol},
                    {"formula", q.formula},
                    {"vector", q.is_vector},
                    {"decimal", decimal},
                    {"hex", hex},
                    {"word", q.word}});
  }
  return list;
}

const Operation& operation_in(const JsonValue& request) {
  const Operation* operation = operations::find(text(request, "op"));
  if (operation == nullptr) throw std::invalid_argument("no operation " + text(request, "op"));
  return *operation;
}

/// Where the numbers of a request stand.
operations::Place in_request() {
  return {kSource, "/in"};
}

operations::Input input_in(const JsonValue& request, const Operation& operation) {
  return operations::read_value(operation, member(request, "in"), in_request());
}

Json evaluated(const JsonValue& request) {
  const Operation& operation = operation_in(request);
  if (!operations::is_of_numbers(operation))
    throw std::invalid_argument(text(request, "op") + " is not evaluated in a scalar");
  const operations::Report report =
      operations::evaluate(operation, input_in(request, operation), text(request, "scalar"));
  return {{"steps", quantities_json(report.steps)}, {"results", quantities_json(report.results)}};
}

Json certified_answer(const JsonValue& request) {
  const Operation& operation = operation_in(request);
  exact::Counters counters;
  if (operation.op == Op::order) {
    const operations::OrderInput input = operations::read_order(member(request, "in"), in_request());
    return {{"order", exact::name(exact::time_order(input.first.query(), input.second.query(), counters))}};
  }
  const auto kind = operations::timing_kind(operation.op);
  if (!kind) throw std::invalid_argument("certified answers are to times at a limit and to order");
  const exact::TimingAnswer answered =
      exact::rounded_time(operations::TimingInput{*kind, input_in(request, operation)}.query(), counters);
  return {{"verdict", name(answered.verdict)},
          {"t", answered.t ? Json(to_hex<double>(*answered.t)) : Json()}};
}

/// The question of a request in hexadecimal floats, as files of known answers have it.
Json question(const Operation& operation, const JsonValue& request) {
  const operations::Input input = input_in(request, operation);
  Json in = Json::object();
  for (const std::string& key : operation.keys) {
    const std::vector<double>& x = input.values.at(key);
    in[key] = x.size() > 1 ? vectors::hex(x) : vectors::hex(x[0]);
  }
  return in;
}

/// A file of one known answer: its header and its case.
Json known_answer(const JsonValue& request) {
  const Operation& operation = operation_in(request);
  const std::string op(operation.name);
  if (operation.op == Op::distance || !operations::is_of_numbers(operation))
    throw std::invalid_argument("known answers are of eqs. (2) to (7), not of " + op);
  const Json in = question(operation, request);
  const Json header{{"schema", "vectors"},
                    {"version", vectors::kVectorsVersion},
                    {"semantics", 1},
                    {"op", op},
                    {"stratum", "page"},
                    {"why", "asked on a page"},
                    {"generator", "tps site"},
                    {"seed", 0},
                    {"first", 0},
                    {"count", 1}};
  Json known{{"id", op + ".page.00000"}, {"rev", 1}, {"in", in}};
  known.update(vectors::known_answer(operation.op, in));
  known["tags"] = Json::array({"page"});
  known["level"] = 3;
  known["accept"] = vectors::accepted_by(operation.op);
  return {{"header", header}, {"case", known}};
}

/// Where A and B are at a time: the inside of eq. (1)'s root, for pictures.
Json flown(const JsonValue& request) {
  const operations::Input input = input_in(request, operations::operation(Op::distance));
  const double t = input.values.at("dt")[0];
  Json places;
  for (const auto& [place, u, v] : {std::array{"A", "u_A", "v_A"}, std::array{"B", "u_B", "v_B"}}) {
    for (std::size_t k = 0; k < input.values.at(u).size(); ++k)
      places[place].push_back(to_hex<double>(input.values.at(u)[k] + input.values.at(v)[k] * t));
  }
  return places;
}

Json built_scene(const JsonValue& request) {
  OptionValues values;
  if (const JsonValue* options = request.find("options")) {
    for (const JsonMember& option : *options->object()) values[option.key] = *option.value.string();
  }
  const Scene scene = scene_builder(text(request, "name")).build(values);
  return {{"scene", Json::parse(write_scene(scene, SceneStyle::compact))}};
}

Json run(const JsonValue& request) {
  const std::string trace =
      (std::filesystem::temp_directory_path() / ("tps-web-" + std::to_string(::getpid()) + ".ndjson"))
          .string();
  certified::ExactTiming certifier;
  RunOptions options;
  options.trace = trace;
  options.until = number(request, "until");
  if (const auto most = number(request, "max_events")) options.max_events = static_cast<std::uint64_t>(*most);
  if (request.find("timing") != nullptr) {
    const auto timing = timing_named(text(request, "timing"));
    if (!timing) throw std::invalid_argument("no timing " + text(request, "timing"));
    options.timing = *timing;
  }
  if (options.timing == Timing::certified) options.certifier = &certifier;
  const RunSummary summary =
      run_scene(read_scene_value(member(request, "scene"), kSource, "/scene"), options);
  std::ostringstream lines;
  lines << std::ifstream(trace).rdbuf();
  std::filesystem::remove(trace);
  return {{"trace", lines.str()},
          {"end", summary.end},
          {"events", summary.events},
          {"stalled_on", summary.stalled_on}};
}

Json answered(std::string_view text_of_request) {
  const JsonDocument document = parse_json(text_of_request, kSource);
  document.problems.throw_if_any();
  const std::string& what = text(document.root, "do");
  if (what == "operations") return operations_json();
  if (what == "eval") return evaluated(document.root);
  if (what == "certified") return certified_answer(document.root);
  if (what == "known_answer") return known_answer(document.root);
  if (what == "flight") return flown(document.root);
  if (what == "scene") return built_scene(document.root);
  if (what == "run") return run(document.root);
  throw std::invalid_argument("nothing is done by \"" + what + "\"");
}

}  // namespace

std::string answer(std::string_view request) {
  try {
    return json_text(answered(request));
  } catch (const std::exception& error) {
    return json_text(Json{{"error", error.what()}});
  }
}

}  // namespace tps::web
