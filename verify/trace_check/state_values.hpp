// Values of a full state as numbers of the check.
#pragma once

#include <fmt/format.h>

#include <stdexcept>

#include "reference/engine/state_data.hpp"
#include "verify/exact/double_word.hpp"
#include "verify/trace_check/number.hpp"
#include "verify/trace_check/text_number.hpp"

namespace tps::check {

/// All throw std::runtime_error where a text is no such value.
template <typename Number>
Number number_in_state(const Hex& text) {
  const std::optional<Number> x = number_of<Number>(text);
  if (!x)
    throw std::runtime_error(fmt::format("\"{}\" is no number of the trace's scalar", text.substr(0, 60)));
  return *x;
}

template <typename Number>
Instant<Number> instant_in_state(const HexTime& t) {
  const Number hi = number_in_state<Number>(t[0]);
  const Number lo = number_in_state<Number>(t[1]);
  if constexpr (std::is_same_v<Number, double>) {
    const exact::DoubleWord sum = exact::two_sum(hi, lo);  // of a float trace hi is the nearest float
    return {sum.hi, sum.lo};
  }
  const Number sum = hi + lo;
  if (!(sum - sum == Number(0))) return {sum, Number(0)};
  return in_two_numbers<Number>(dyadic(hi) + dyadic(lo));
}

template <typename Number>
Vec<Number> vector_in_state(const HexVector& x, int dimension) {
  if (x.size() != static_cast<std::size_t>(dimension))
    throw std::runtime_error("a vector has another dimension");
  Vec<Number> result;
  for (std::size_t k = 0; k < x.size(); ++k) result[k] = number_in_state<Number>(x[k]);
  return result;
}

/// One number in the plane, along z.
template <typename Number>
Vec<Number> spin_in_state(const std::vector<Hex>& spin) {
  Vec<Number> result;
  for (std::size_t k = 0; k < std::min<std::size_t>(spin.size(), 3); ++k)
    result[spin.size() == 1 ? 2 : k] = number_in_state<Number>(spin[k]);
  return result;
}

}  // namespace tps::check
