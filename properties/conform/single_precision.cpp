#include "properties/conform/single_precision.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "properties/conform/asked_otherwise.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps::properties::conform {
namespace {

/// Orders of evaluation differ by a few units of float, times the condition of the question.
constexpr double kFewUnits = 0x1p-21;
constexpr double kLeastError = 0x1p-30;
constexpr double kNearer = 100;

double in_single(double x) {
  static const Format format = Format::of_bits(24);
  return format.rounded(x);
}

Json rounded(const Json& value) {
  if (value.is_structured()) {
    Json copy = value;
    for (Json& each : copy) each = rounded(each);
    return copy;
  }
  if (!value.is_string()) return value;
  const auto x = numbers_of(value);
  return x && std::isfinite(x->front()) ? Json(to_hex<double>(in_single(x->front()))) : value;
}

Json rounded(const Vec& x) {
  Json list = Json::array();
  for (const double each : x) list.push_back(to_hex<double>(in_single(each)));
  return list;
}

double condition(const Expected& right) {
  double largest = 1;
  for (const ExpectedNumbers& numbers : right.numbers) largest = std::max(largest, numbers.cond.value_or(1));
  return largest;
}

/// Both particles seen from A, in floats.
std::optional<Json> seen_from_A(const Json& in) {
  if (!in.contains("u_B")) return std::nullopt;
  const Given g(in);
  Json moved = in;
  moved["u_A"] = moved["v_A"] = rounded(Vec(g.vec("u_A").size()));
  moved["u_B"] = rounded(g.r());
  moved["v_B"] = rounded(g.v());
  return moved;
}

}  // namespace

bool is_single_precision(const KnownQuestion& known, const Json& out, const Expected& right) {
  const Vec found = numbers_as(right, out);
  if (found.empty()) return false;
  const Op op = known.question.op;
  const Json in = rounded(known.question.in);
  if (std::all_of(found.begin(), found.end(), [](double x) { return x == in_single(x); }))
    return apart(found, reference_answer("float", op, in, right)) <= kFewUnits * condition(right);
  const double error = apart(found, nearest_numbers(right));
  const auto is_near = [&](const Json& asked) {
    return apart(found, reference_answer("double", op, asked, right)) * kNearer <= error;
  };
  if (!(error > kLeastError)) return false;
  if (is_near(in)) return true;
  const auto moved = seen_from_A(known.question.in);
  return moved && right.numbers.size() == 1 && is_near(*moved);
}

}  // namespace tps::properties::conform
