#include "verify/vectors/known_answer.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/operations/compound_input.hpp"
#include "verify/operations/timing_input.hpp"
#include "verify/vectors/drag_proof.hpp"
#include "verify/vectors/question.hpp"
#include "verify/vectors/response_answer.hpp"
#include "verify/vectors/time_bracket.hpp"

namespace tps::vectors {
namespace {

using exact::Kind;
using exact::TimingQuery;
using exact::Vec3;

Json vector_of(const Vec3& x, int dimension) {
  return hex(std::vector<double>(x.begin(), x.begin() + dimension));
}

/// A question with hexadecimal floats for every number, as generators write it: most are such, and reading
/// them costs as much as answering them. Nothing where another spelling, or a refusal, may be right.
std::optional<TimingQuery> spelt_by_us(Kind kind, const Json& in) {
  constexpr std::array<const char*, 4> kVectors{"u_A", "u_B", "v_A", "v_B"};
  const auto number = [](const Json& value) {
    const HexFloat x = value.is_string() ? parse_hex_float(value.get_ref<const std::string&>()) : HexFloat{};
    return x.verdict == HexFloat::Verdict::exact && std::isfinite(x.value) ? std::optional(x.value)
                                                                           : std::nullopt;
  };
  if (kind == Kind::plane || !in.is_object() || in.size() != kVectors.size() + 1) return std::nullopt;
  std::array<Vec3, kVectors.size()> x{};
  std::size_t dimension = 0;
  for (std::size_t n = 0; n < kVectors.size(); ++n) {
    const auto vector = in.find(kVectors[n]);
    if (vector == in.end() || !vector->is_array() || vector->size() < 2 || vector->size() > 3)
      return std::nullopt;
    if (n == 0) dimension = vector->size();
    if (vector->size() != dimension) return std::nullopt;
    for (std::size_t k = 0; k < dimension; ++k) {
      const auto component = number((*vector)[k]);
      if (!component) return std::nullopt;
      x[n][k] = *component;
    }
  }
  const auto L = in.find("L");
  const auto limit = L == in.end() ? std::nullopt : number(*L);
  if (!limit || !(*limit > 0)) return std::nullopt;
  return TimingQuery{kind, x[0], x[1], x[2], x[3], *limit};
}

void add_bracket(const TimeBracket& b, Json& answer, Json& signs) {
  answer["t"] = {hex(b.lo), hex(b.hi)};
  answer["nearest"] = b.nearest == b.lo ? "lo" : "hi";
  signs["lo"] = b.sign_lo;
  signs["hi"] = b.sign_hi;
  signs["mid"] = b.sign_mid;
}

Json timing_answer(const TimingQuery& query) {
  const TimingProof proof = prove(query);
  Json answer{{"verdict", name(proof.verdict)}};
  Json signs{{"A", proof.A}, {"B", proof.B}, {"C", proof.C}, {"D", proof.sign_D}};
  if (proof.bracket) {
    add_bracket(*proof.bracket, answer, signs);
  } else if (exact::at_once(proof.verdict)) {
    answer["t"] = {hex(0), hex(0)};
    answer["nearest"] = "lo";
  } else {
    answer["t"] = nullptr;
  }
  answer["proof"] = signs;
  answer["cond"] = rounded_condition(condition(query, proof));
  return answer;
}

/// The numbers of a question.
operations::Input input_of(Op op, const Json& in) {
  return operations::read_value(operations::operation(op), question_value(in), {kQuestion, "/in"});
}

Json drag_answer(const operations::Input& input) {
  const DragProof proof = prove_drag_time(input.values.at("gamma")[0], input.values.at("s")[0]);
  Json answer{{"verdict", proof.bracket ? "reached" : "never"}, {"t", nullptr}};
  Json signs{{"z", proof.z}};
  if (proof.bracket) add_bracket(*proof.bracket, answer, signs);
  answer["proof"] = signs;
  answer["cond"] = rounded_condition(proof.condition);
  return answer;
}

Json order_answer(const Json& in) {
  exact::Counters counters;
  const operations::OrderInput input = operations::read_order(question_value(in), {kQuestion, "/in"});
  const std::array<TimingQuery, 2> queries{input.first.query(), input.second.query()};
  Json proof;
  for (std::size_t n = 0; n < 2; ++n) {
    const char* key = n == 0 ? "first" : "second";
    const TimingProof one = prove(queries[n]);
    proof[key] = {
        {"verdict", name(one.verdict)}, {"A", one.A}, {"B", one.B}, {"C", one.C}, {"D", one.sign_D}};
  }
  return {{"order", exact::name(exact::time_order(queries[0], queries[1], counters))}, {"proof", proof}};
}

}  // namespace

Json rounded_condition(const std::optional<double>& condition) {
  if (!condition || !std::isfinite(*condition)) return nullptr;
  return std::stod(fmt::format("{:.2e}", *condition));
}

Json hex(double x) {
  return to_hex<double>(x);
}

Json hex(const std::vector<double>& x) {
  Json components = Json::array();
  for (const double component : x) components.push_back(hex(component));
  return components;
}

double read_number(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) {
    const std::string& text = value.get_ref<const std::string&>();
    if (text == "inf") return HUGE_VAL;
    const HexFloat number = parse_hex_float(text);
    if (number.verdict == HexFloat::Verdict::exact) return number.value;
  }
  throw std::invalid_argument(
      fmt::format("{} is not a number; allowed: a JSON number, a hexadecimal float, \"inf\"", shown(value)));
}

std::vector<double> read_vector(const Json& value) {
  if (!value.is_array() || value.size() < 2 || value.size() > 3) {
    throw std::invalid_argument(fmt::format("{} is not a list of 2 or 3 numbers", shown(value)));
  }
  std::vector<double> x;
  for (const Json& component : value) x.push_back(read_number(component));
  return x;
}

Json timing_input(const TimingQuery& query, int dimension) {
  Json in{{"u_A", vector_of(query.u_A, dimension)},
          {"u_B", vector_of(query.u_B, dimension)},
          {"v_A", vector_of(query.v_A, dimension)},
          {"v_B", vector_of(query.v_B, dimension)},
          {"L", hex(query.L)}};
  if (query.kind == Kind::plane) in["normal"] = vector_of(query.normal, dimension);
  return in;
}

TimingQuery read_timing_input(Kind kind, const Json& in) {
  if (const auto query = spelt_by_us(kind, in)) return *query;
  return operations::TimingInput{kind, input_of(operations::timing_of(kind), in)}.query();
}

Json known_answer(Op op, const Json& in) {
  if (op == Op::drag_time) return drag_answer(input_of(op, in));
  if (op == Op::order) return order_answer(in);
  if (const auto kind = operations::timing_kind(op)) return timing_answer(read_timing_input(*kind, in));
  return response_answer(op, in);
}

Json accepted_by(Op op) {
  Json classes = Json::array({"R"});
  if (const int k = operations::operation(op).accepted_k; k > 0) classes.push_back(fmt::format("K({})", k));
  return classes;
}

}  // namespace tps::vectors
