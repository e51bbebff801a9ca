#include "reference/text/background_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <future>
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

TEST(BackgroundWriter, HasTextMadeInItsOrder) {
  std::string written, expected;
  BackgroundWriter writer([&](std::string_view text) { written.append(text); });
  for (int n = 0; n < 1000; ++n) {
    const std::string piece = std::to_string(n) + " ";
    expected.append(piece);
    if (n % 3 == 0) {
      std::string buffer = piece;
      writer.hand_over(buffer);
    } else {
      writer.hand_over([piece](std::string& text) { text.append(piece); });
    }
  }
  writer.wait();
  EXPECT_EQ(written, expected);
}

TEST(BackgroundWriter, WaitsForNothingWhileThereIsAPlace) {
  std::promise<void> may_go_on;
  BackgroundWriter writer([go = may_go_on.get_future().share()](std::string_view) { go.wait(); });
  for (std::size_t n = 0; n < BackgroundWriter::kMostPending; ++n) {
    std::string buffer = "x";
    writer.hand_over(buffer);
  }
  may_go_on.set_value();
  writer.wait();
}

TEST(BackgroundWriter, LeavesAsManyMadeTextsUnfinishedAsItSays) {
  constexpr int kPieces = 200;
  std::array<std::atomic<bool>, kPieces> done{};
  BackgroundWriter writer([](std::string_view) {});
  for (int n = 0; n < kPieces; ++n) {
    writer.hand_over([&done, n](std::string&) { done[static_cast<std::size_t>(n)] = true; });
    const int past = n - static_cast<int>(BackgroundWriter::kMostPending);
    if (past < 0) continue;
    EXPECT_TRUE(done[static_cast<std::size_t>(past)]) << n;
  }
  writer.settle();
  EXPECT_TRUE(done.back());
}

TEST(BackgroundWriter, WritesNothingBehindWhatFailed) {
  std::promise<void> may_go_on;
  std::string written;
  BackgroundWriter writer([&, go = may_go_on.get_future().share()](std::string_view text) {
    go.wait();
    if (text == "b") throw std::runtime_error("full");
    written.append(text);
  });
  for (const char* const piece : {"a", "b", "c", "d"}) {
    std::string buffer = piece;
    writer.hand_over(buffer);
  }
  may_go_on.set_value();
  EXPECT_THROW(writer.wait(), std::runtime_error);
  EXPECT_EQ(written, "a");
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
