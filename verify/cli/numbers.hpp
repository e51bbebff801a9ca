// What numbers an option takes. CLI11's own ranges let nan through, and its conversions inf.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tps::cli {

/// Numbers from `least` to `most`; `what` says in messages what it is.
CLI::Validator number_from(double least, double most, const std::string& what);
/// Numbers above 0 and below `most`.
CLI::Validator number_above_zero(double below, const std::string& what);
/// Integers from `least`, below 2^64.
CLI::Validator integer_from(std::uint64_t least, const std::string& what);

}  // namespace tps::cli
