// A text file read whole, with a limit.
#pragma once

#include <cstddef>
#include <string>

namespace tps {

/// The bytes of a file; path "-" is the standard input. Reads no more than `max_bytes` + 1 bytes whatever
/// the file is (a device, a pipe). `remedy` ends the message about a file that is larger.
/// Throws InputError: missing, unreadable, a directory, larger than `max_bytes`.
std::string read_text_file(const std::string& path, std::size_t max_bytes, const std::string& remedy);

/// What messages call the file: the path itself, "standard input" for "-".
std::string display_name(const std::string& path);

}  // namespace tps
