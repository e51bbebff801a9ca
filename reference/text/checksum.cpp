#include "reference/text/checksum.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

namespace tps {

std::string checksum_of(std::string_view text) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, 0xFFFFFFFFFFFFFFFFULL, 0xFFFFFFFFFFFFFFFFULL, true, true> crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("crc64:{:016x}", crc.checksum());
}

std::string with_checksum(std::string object) {
  const std::string checksum = checksum_of(object);
  object.pop_back();
  return object.append(",\"checksum\":\"").append(checksum).append("\"}");
}

}  // namespace tps
