#include "properties/conform/response_margin.hpp"

#include <algorithm>

#include "properties/conform/expected.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::conform {
namespace {

Vec3 vector_of(const Json& in, const char* key) {
  const std::vector<double> x = numbers_of(in.at(key)).value();
  return {x.at(0), x.at(1), x.size() > 2 ? x[2] : 0};
}

double number_of(const Json& in, const char* key) {
  return numbers_of(in.at(key)).value().at(0);
}

}  // namespace

bool kind_is_open(const Question& question, int bits) {
  const Json& in = question.in;
  const Encounter x({vector_of(in, "u_A"), vector_of(in, "u_B"), vector_of(in, "v_A"), vector_of(in, "v_B")});
  const Wide angle = radians(number_of(in, "theta_revolve_deg"));
  const Wide slope = sin(angle) / cos(angle), c = number_of(in, "c_retract");
  const Wide apart = abs(Wide(c * abs(x.v_n) - slope * x.tangential));
  return apart <= 8 * ldexp(Wide(1), -bits) * (c + slope) * x.speed * kSlack;
}

}  // namespace tps::properties::conform
