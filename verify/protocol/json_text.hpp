// Pieces of JSON text: numbers as hexadecimal floats, strings quoted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verify/certified/certified_response.hpp"

namespace tps::protocol {

/// "0x1.8p+1" or "inf", in quotes.
std::string quoted_number(double x);

std::string vector_text(const std::vector<double>& components);

/// The correctly rounded components.
std::string vector_text(const certified::EnclosedVector& components);

/// Any text as a JSON string; bytes that are not UTF-8 become U+FFFD.
std::string quoted(std::string_view text);

}  // namespace tps::protocol
