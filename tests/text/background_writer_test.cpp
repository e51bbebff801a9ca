#include "reference/text/background_writer.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tps {
namespace {

TEST(BackgroundWriter, WritesEverythingInItsOrder) {
  std::string written, expected;
  {
    BackgroundWriter writer([&](std::string_view text) { written.append(text); });
    std::string buffer;
    for (int n = 0; n < 1000; ++n) {
      const std::string piece = std::to_string(n) + " ";
      buffer.append(piece);
      expected.append(piece);
      if (n % 7 != 0) continue;
      writer.hand_over(buffer);
      EXPECT_TRUE(buffer.empty());
    }
    writer.hand_over(buffer);
    writer.wait();
    EXPECT_EQ(written, expected);
    buffer = "the end";
    writer.hand_over(buffer);
  }
  EXPECT_EQ(written, expected + "the end") << "what was handed over last is written before it is gone";
}

TEST(BackgroundWriter, SaysWhatWentWrongOnce) {
  BackgroundWriter writer([](std::string_view) { throw std::runtime_error("full"); });
  std::string buffer = "x";
  writer.hand_over(buffer);
  EXPECT_THROW(writer.wait(), std::runtime_error);
  EXPECT_NO_THROW(writer.wait());
}

}  // namespace
}  // namespace tps
