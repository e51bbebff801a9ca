// Numbers that were written with few decimal digits: one cause of findings at every step.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
    std::vector<double>& seen = seen_[kind];
    if (seen.size() >= kAtMost || (std::bit_cast<std::uint64_t>(x) & kLowBits) == 0 || !(x - x == 0)) return;
    seen.push_back(x);
  }

  /// Whether no further number of any kind is of interest.
  bool has_enough() const {
    return std::ranges::all_of(seen_, [](const auto& seen) { return seen.size() >= kAtMost; });
  }

  /// As if what was added to another one had been added here.
  void take_over(const DecimalDigits& other) {
    for (std::size_t kind = 0; kind < seen_.size(); ++kind) {
      const std::vector<double>& others = other.seen_[kind];
      const std::size_t room = kAtMost - seen_[kind].size();
      const auto end = others.begin() + static_cast<std::ptrdiff_t>(std::min(room, others.size()));
      seen_[kind].insert(seen_[kind].end(), others.begin(), end);
    }
  }

  /// What to do about it, where nine numbers in ten of a kind, and eight of them, have few digits.
  std::optional<std::string> advice() const {
    static constexpr std::array<std::string_view, 3> kNames = {"times", "velocities", "positions"};
    for (const std::size_t kind : {times, positions, velocities}) {
      const std::vector<double>& seen = seen_[kind];
      if (seen.size() < kEnough) continue;
      std::array<std::size_t, 32> of_length{};
      for (const double x : seen) ++of_length[digits_of(x)];
      std::size_t few = 0;
      std::size_t digits = 0;
      while (digits < of_length.size() && few * 10 < seen.size() * 9) few += of_length[digits++];
      if (digits - 1 > kFew) continue;
      return fmt::format(
          "the {} look like decimals of {} digits, which is not enough for a double: write hexadecimal "
          "floats (\"0x1.8p+1\") or 17 digits",
          kNames[kind], digits - 1);
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kEnough = 8, kAtMost = 10'000;
  static constexpr std::size_t kFew = 14;

  static std::size_t digits_of(double x) {
    std::array<char, 40> buffer;
    const char* const end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::scientific).ptr;
    const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    const std::string_view mantissa = text.substr(0, text.find('e'));
    const std::size_t first = mantissa.find_first_of("123456789");
    const auto digits = std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                      [](char c) { return c >= '0' && c <= '9'; });
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(digits, 1, 31));
  }

  std::array<std::vector<double>, 3> seen_;
};

}  // namespace tps::check
