// Versions that every file we write names.
#pragma once

#include <string_view>

namespace tps {

/// The project's version, as in CMakeLists.txt.
std::string_view version();

/// The version of the page of semantics that fixes what the paper leaves open (docs/decisions.md).
inline constexpr int kSemanticsVersion = 2;
/// The first version in which responses are rounded directedly (D22), and the oldest whose traces are read.
inline constexpr int kDirectedSemantics = 2;
inline constexpr int kOldestSemantics = 1;

}  // namespace tps
