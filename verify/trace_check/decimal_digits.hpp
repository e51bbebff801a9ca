// Numbers that were written with few decimal digits: one cause of findings at every step.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>

namespace tps::check {

/// Counts the digits of the shortest decimals that spell the doubles of a trace.
///
/// Nearly all doubles that come out of a computation take 16 or 17; of those that were rounded to 12 digits
/// nearly all take 12. Short binary fractions, which are exact in few digits, say nothing.
class DecimalDigits {
 public:
  enum Kind : std::size_t { times, velocities, positions };

  void add(Kind kind, double x) {
    constexpr std::uint64_t kLowBits = 0xffff;
    Seen& seen = seen_[kind];
    if ((std::bit_cast<std::uint64_t>(x) & kLowBits) == 0 || !(x - x == 0) || seen.count >= kAtMost) return;
    ++seen.count;
    const std::string text = fmt::format("{}", x);
    const std::string_view mantissa = std::string_view(text).substr(0, text.find('e'));
    const std::size_t first = mantissa.find_first_of("123456789");
    const auto digits = std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                      [](char c) { return c >= '0' && c <= '9'; });
    ++seen.of_length[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(digits, 1, 31))];
  }

  /// What to do about it, where nine numbers in ten of a kind, and eight of them, have few digits.
  std::optional<std::string> advice() const {
    static constexpr std::array<std::string_view, 3> kNames = {"times", "velocities", "positions"};
    for (const std::size_t kind : {times, positions, velocities}) {
      const Seen& seen = seen_[kind];
      if (seen.count < kEnough) continue;
      std::uint64_t few = 0;
      std::size_t digits = 0;
      while (digits < seen.of_length.size() && few * 10 < seen.count * 9) few += seen.of_length[digits++];
      if (digits - 1 > kFew) continue;
      return fmt::format(
          "the {} look like decimals of {} digits, which is not enough for a double: write hexadecimal "
          "floats (\"0x1.8p+1\") or 17 digits",
          kNames[kind], digits - 1);
    }
    return std::nullopt;
  }

 private:
  static constexpr std::uint64_t kEnough = 8, kAtMost = 10'000;
  static constexpr std::size_t kFew = 14;
  struct Seen {
    std::uint64_t count = 0;
    std::array<std::uint64_t, 32> of_length{};
  };
  std::array<Seen, 3> seen_;
};

}  // namespace tps::check
