#include "reference/text/pen.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>

#include "reference/scalars.hpp"

namespace tps {
namespace {

/// One piece in turn with a pen and with what spells it alone; a text far longer than the room that is asked
/// for at once.
TEST(Pen, WritesWhatIsSpeltAlone) {
  std::mt19937_64 bits(4);
  std::string written = "before ", expected = written;
  for (int line = 0; line < 50; ++line) {
    Pen pen(written);
    for (int n = 0; n < 40; ++n) {
      const double x = std::ldexp(double(bits()), int(bits() % 200) - 100);
      const double lo = std::ldexp(x, -55 - int(bits() % 9));
      pen.put_hex(x);
      append_hex(expected, x);
      pen.put_hex_sum(x, lo);
      append_hex_sum(expected, x, lo);
      pen.put(",\"key\":");
      expected.append(",\"key\":");
      pen.put('x');
      expected.push_back('x');
      const std::string longer(bits() % 3000, '.');
      pen.put_text(longer);
      expected.append(longer);
      pen.put_natural(line * n);
      expected.append(std::to_string(line * n));
    }
  }
  EXPECT_EQ(written, expected);
}

TEST(Pen, WritesIntegersOfEveryLength) {
  for (const std::uint64_t n :
       {std::uint64_t{0}, std::uint64_t{9}, std::numeric_limits<std::uint64_t>::max()}) {
    std::string text;
    Pen(text).put_natural(n);
    EXPECT_EQ(text, std::to_string(n));
  }
  std::string text;
  Pen(text).put_natural(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(text, "-9223372036854775808");
}

/// Sums that two words do not hold, and scalars that are no double.
TEST(Pen, WritesWhatTakesTheLongRoad) {
  std::string text;
  {
    Pen pen(text);
    pen.put_hex_sum(1.0, 0x1p-1000);
    pen.put(' ');
    pen.put_hex(Mp50(1) / 3);
    pen.put(' ');
    pen.put_hex_sum(Quad(1), ldexp(Quad(1), -200));
    pen.put(' ');
    pen.put_hex(1.5F);
  }
  std::string expected;
  append_hex_sum(expected, 1.0, 0x1p-1000);
  expected.append(" ").append(to_hex(Mp50(Mp50(1) / 3))).append(" ");
  append_hex_sum(expected, Quad(1), Quad(ldexp(Quad(1), -200)));
  EXPECT_EQ(text, expected + " 0x1.8p+0");
}

}  // namespace
}  // namespace tps
