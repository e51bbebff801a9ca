// Checksums of lines: what a disk, a copy or an editor has changed is noticed.
#pragma once

#include <string>
#include <string_view>

namespace tps {

/// "crc64:" and the 16 hexadecimal digits of the CRC-64 with the polynomial of ECMA-182 (reflected, as in
/// xz): every change within 64 bits in a row is noticed, any other but one in 2^64. (1)
/// checksum_of("123456789") is crc64:995dc9bbdf1939fa.
std::string checksum_of(std::string_view text);

/// The text of a JSON object with the checksum of that text as its last member, "checksum". REQUIRES an
/// object that is not empty.
std::string with_checksum(std::string object);

}  // namespace tps
