// What is wrong with a text that is no JSON, in words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tps {

/// A message for an error of the JSON library: its number, what it says of it, the text, and how many of its
/// bytes the parser had consumed. Names the word that it met and the column; quotes no more than a line.
std::string json_syntax_message(int id, std::string_view what, std::string_view text, std::size_t consumed);

}  // namespace tps
