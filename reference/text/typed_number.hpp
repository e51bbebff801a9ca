// Numbers as people type them, at options and in key=value.
#pragma once

#include <optional>
#include <string>

namespace tps {

struct TypedNumber {
  std::optional<double> value;
  std::string reason;  ///< why there is none, behind "…": "is not a number; …"
};

/// A decimal, of which the nearest double is taken; a hexadecimal float (hex_spelling in hexfloat.hpp),
/// exactly; "inf", "+inf" or "-inf". Never NaN. Law: typed_number(to_hex(x)) is x,
/// typed_number(write_shortest(x)), too.
TypedNumber typed_number(const std::string& text);

}  // namespace tps
