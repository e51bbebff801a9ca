#include "reference/run/time_since_start.hpp"

#include <cmath>
#include <cstdlib>

#include "reference/engine/drag_clock.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps {
namespace {

/// REQUIRES a number of a state that has been read.
Dyadic exactly(const Hex& text) {
  const HexDigits number = split_hex(text).value_or(HexDigits{});
  const boost::multiprecision::cpp_int digits("0x0" + number.digits);
  return {number.negative ? boost::multiprecision::cpp_int(-digits) : digits, number.exponent};
}

}  // namespace

double nearest(const Hex& text) {
  return std::strtod(text.c_str(), nullptr);
}
double nearest(const HexTime& time) {
  return nearest(time[0]) + nearest(time[1]);
}

double time_since_start(const Scene& scene, const HexTime& now) {
  if (!scene.drag) return nearest(now);
  const Dyadic s = exactly(now[0]) + exactly(now[1]);
  const bool is_reached = drag_factor(scene.drag->gamma, s).sign() > 0;
  return is_reached ? drag_time(scene.drag->gamma, s, 0) : HUGE_VAL;
}

}  // namespace tps
