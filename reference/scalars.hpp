// The scalar types that the engine is compiled for, and their names in commands and files.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cstddef>
#include <limits>
#include <string_view>

#include "reference/equations/wide_square_root.hpp"
#include "reference/scalar_kind.hpp"

namespace tps {

using Quad = boost::multiprecision::cpp_bin_float_quad;  ///< 113 bits
using Mp50 = boost::multiprecision::cpp_bin_float_50;    ///< at least 50 decimal digits
using Mp100 = boost::multiprecision::cpp_bin_float_100;  ///< at least 100 decimal digits

/// The name of a scalar type in `--scalar` and in trace headers.
template <typename Scalar>
inline constexpr std::string_view scalar_name = "";
template <>
inline constexpr std::string_view scalar_name<float> = "float";
template <>
inline constexpr std::string_view scalar_name<double> = "double";
template <>
inline constexpr std::string_view scalar_name<long double> = "long-double";
template <>
inline constexpr std::string_view scalar_name<Quad> = "quad";
template <>
inline constexpr std::string_view scalar_name<Mp50> = "mp50";
template <>
inline constexpr std::string_view scalar_name<Mp100> = "mp100";

template <typename... Scalars>
struct ScalarList {
  static constexpr std::array<std::string_view, sizeof...(Scalars)> names{scalar_name<Scalars>...};
  /// Of their significands.
  static constexpr std::array<int, sizeof...(Scalars)> bits{std::numeric_limits<Scalars>::digits...};

  /// ask.operator()<Scalar>() of one of them.
  template <typename Result, typename Ask>
  static Result with(ScalarKind scalar, const Ask& ask) {
    constexpr std::array<Result (*)(const Ask&), sizeof...(Scalars)> asks{
        [](const Ask& each) -> Result { return each.template operator()<Scalars>(); }...};
    return asks.at(static_cast<std::size_t>(scalar))(ask);
  }
};

/// The one list, in the order of ScalarKind: names, digits and dispatches are made of it.
using AllScalars = ScalarList<float, double, long double, Quad, Mp50, Mp100>;

}  // namespace tps
