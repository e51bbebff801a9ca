// Doubles from and as text, exactly: hexadecimal floats and shortest decimals.
#pragma once

#include <string>
#include <string_view>

namespace tps {

/// A hexadecimal float read from a file.
struct HexFloat {
  enum class Verdict {
    exact,         ///< `value` is the number that was written
    malformed,     ///< not spelt as hex_spelling (hexfloat.hpp) has it
    not_a_double,  ///< well formed, but no double has this value
  };
  Verdict verdict = Verdict::malformed;
  double value = 0;
};

/// Reads the whole of `text`. Unlike strtod it never rounds: a number that no double has is reported.
/// (1) parse_hex_float(to_hex(x)) is x, bit for bit, for every finite x.
HexFloat parse_hex_float(std::string_view text);

/// The shortest decimal that reads back as the same double, as a JSON number ("0.1", "-0.0", "1e+22").
/// REQUIRES finite.
std::string write_shortest(double value);

}  // namespace tps
