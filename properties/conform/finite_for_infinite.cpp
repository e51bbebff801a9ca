#include "properties/conform/finite_for_infinite.hpp"

#include <cmath>

#include "properties/conform/asked_otherwise.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps::properties::conform {
namespace {

/// @return whether anything was infinite.
bool replace_infinity(Json& value, double mass) {
  if (value == "inf") {
    value = to_hex<double>(mass);
    return true;
  }
  bool any = false;
  if (value.is_structured()) {
    for (Json& each : value) any = replace_infinity(each, mass) || any;
  }
  return any;
}

}  // namespace

bool is_of_finite_mass(const KnownQuestion& known, const Json& out, const Expected& right) {
  constexpr double kNearer = 10;
  const Vec found = numbers_as(right, out);
  if (found.empty()) return false;
  const double error = apart(found, nearest_numbers(right));
  for (int power = 3; power <= 18; ++power) {
    Json in = known.question.in;
    if (!replace_infinity(in, std::pow(10, power))) return false;
    if (apart(found, reference_answer("double", known.question.op, in, right)) * kNearer <= error)
      return true;
  }
  return false;
}

}  // namespace tps::properties::conform
