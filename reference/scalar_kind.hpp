// Which scalar, by name or by kind, without the scalars themselves (scalars.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tps {

/// The scalars that the engine is compiled for, by their names in commands and files.
enum class ScalarKind { float_, double_, long_double, quad, mp50, mp100 };

/// Of its significand: 24, 53, 64, 113, 168, 334.
int significant_bits(ScalarKind scalar);

/// "float", "double", "long-double", "quad", "mp50", "mp100", in this order.
const std::vector<std::string>& scalar_names();
/// Nothing for an unknown name.
std::optional<ScalarKind> scalar_kind(std::string_view name);

}  // namespace tps
