// A step as a case of one operation, for `tps eval` and known-answer files.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/text/hexfloat.hpp"
#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/pair_flight.hpp"
#include "verify/trace_check/report.hpp"

namespace tps::check {

/// Builds the "in" of an operation: doubles; wider numbers are rounded to them.
class ReplayInput {
 public:
  explicit ReplayInput(int dimension) : dimension_(dimension) {}

  template <typename T>
  ReplayInput& vector(const char* key, const Vec<T>& x) {
    std::string text = "[";
    for (int k = 0; k < dimension_; ++k) {
      text += (k == 0 ? "\"" : ",\"") + hex(x[static_cast<std::size_t>(k)]) + "\"";
    }
    return add(key, text + "]");
  }
  template <typename T>
  ReplayInput& number(const char* key, const T& x) {
    return add(key, "\"" + hex(x) + "\"");
  }
  std::string json() const { return "{" + text_ + "}"; }

 private:
  template <typename T>
  static std::string hex(const T& x) {
    return to_hex<double>(static_cast<double>(x));
  }
  ReplayInput& add(const char* key, const std::string& value) {
    text_ += (text_.empty() ? "\"" : ",\"") + std::string(key) + "\":" + value;
    return *this;
  }

  int dimension_;
  std::string text_;
};

template <typename W>
double mass_of(const W& inverse) {
  return inverse == W(0) ? HUGE_VAL : static_cast<double>(W(1) / inverse);
}

template <typename Number>
Replay replay_of_time(const PairFlight<Number>& pair, bool outer, const Work<Number>& L, int dimension) {
  ReplayInput in(dimension);
  in.vector("u_A", pair.u_i)
      .vector("u_B", widened<Work<Number>>(pair.u_j) + pair.shift())
      .vector("v_A", pair.v_i)
      .vector("v_B", pair.v_j)
      .number("L", L);
  return {outer ? operations::Op::tether_time : operations::Op::block_time, in.json()};
}

/// Positions and velocities of the pair, masses of the bodies.
template <typename Number>
ReplayInput replay_of_bodies(const BodiesNow<Number>& b, const Vec<Work<Number>>& u_i,
                             const Vec<Work<Number>>& u_j, int dimension) {
  ReplayInput in(dimension);
  in.vector("u_A", u_i).vector("u_B", u_j).vector("v_A", b.v_i).vector("v_B", b.v_j);
  in.number("m_A", mass_of(b.inverse_i)).number("m_B", mass_of(b.inverse_j));
  return in;
}

}  // namespace tps::check
