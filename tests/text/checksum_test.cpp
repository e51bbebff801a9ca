#include "reference/text/checksum.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tps {
namespace {

TEST(Checksum, IsTheCrcOfXz) {
  EXPECT_EQ(checksum_of("123456789"), "crc64:995dc9bbdf1939fa");  // the check value of CRC-64/XZ
  EXPECT_EQ(checksum_of(""), "crc64:0000000000000000");
}

TEST(Checksum, NoticesEveryChangeWithinEightBytes) {
  std::mt19937 random(1);
  std::string text(500, '\0');
  for (char& c : text) c = static_cast<char>(random());
  const std::string right = checksum_of(text);
  for (int n = 0; n < 1000; ++n) {
    std::string changed = text;
    const std::size_t at = random() % (text.size() - 8);
    for (std::size_t k = 0; k < 1 + random() % 8; ++k) changed[at + k] = static_cast<char>(random());
    EXPECT_EQ(checksum_of(changed) == right, changed == text);
  }
}

TEST(Checksum, StandsLastInItsObject) {
  EXPECT_EQ(with_checksum("{\"a\":1}"), "{\"a\":1,\"checksum\":\"" + checksum_of("{\"a\":1}") + "\"}");
}

}  // namespace
}  // namespace tps
