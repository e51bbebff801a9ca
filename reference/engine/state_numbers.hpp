// The engine's numbers to and from those of StateData, without rounding.
#pragma once

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "reference/engine/clock.hpp"
#include "reference/engine/state_data.hpp"
#include "reference/equations/vector.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps::detail {

template <typename Scalar>
HexTime time_data(const Time<Scalar>& t) {
  return {to_hex(t.hi), to_hex(t.lo)};
}

template <typename Scalar, int D>
HexVector vector_data(const Vector<Scalar, D>& v) {
  HexVector data;
  for (int k = 0; k < D; ++k) data.push_back(to_hex(Scalar(v[k])));
  return data;
}

template <typename Scalar>
Scalar number_from(const Hex& text) {
  const std::optional<Scalar> value = from_hex<Scalar>(text);
  if (!value)
    throw std::runtime_error("'" + text + "' is not a hexadecimal float that the scalar holds exactly");
  return *value;
}

template <typename Scalar>
Scalar finite_from(const Hex& text) {
  using std::abs;
  const Scalar value = number_from<Scalar>(text);
  if (abs(value) == std::numeric_limits<Scalar>::infinity())
    throw std::runtime_error("'" + text + "' stands where only a finite number can");
  return value;
}

template <typename Scalar>
Time<Scalar> time_from(const HexTime& data) {
  return {finite_from<Scalar>(data[0]), finite_from<Scalar>(data[1])};
}

template <typename Scalar, int D>
Vector<Scalar, D> vector_from(const HexVector& data) {
  if (data.size() != static_cast<std::size_t>(D)) throw std::runtime_error("a vector has the wrong length");
  Vector<Scalar, D> v;
  for (int k = 0; k < D; ++k) v[k] = finite_from<Scalar>(data[static_cast<std::size_t>(k)]);
  return v;
}

}  // namespace tps::detail
