// A document of any other format than ours to walk through: nlohmann's JSON, read by our one strict reader.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "reference/text/json_document.hpp"

namespace tps {

/// Reads a text as parse_json() does, with its limits, and refuses keys that stand twice. Integers keep their
/// 64 bits, keys their order. Throws InputError, each problem with `name`, its line and its pointer.
nlohmann::ordered_json parse_plain_json(std::string_view text, const std::string& name,
                                        const JsonLimits& limits = {}, std::size_t first_line = 1);

/// The text of a JSON value, safe on a terminal too: what printable() escapes stands as \\u escapes of JSON,
/// so that readers get the same strings; bytes that are not UTF-8 become U+FFFD. `indent` as in dump().
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

/// A value of a found document as JSON, as much of it as a line of a message can bear.
std::string shown(const nlohmann::ordered_json& value);

/// The first thing that is wrong, without the file and the line: "/in/u_A: must be …". For readers of lines,
/// which say themselves where they are.
std::string first_problem(const InputError& error);

}  // namespace tps
