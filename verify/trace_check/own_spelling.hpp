// Events spelt as `tps run` spells them, read in one pass. Whatever is spelt otherwise is left to
// read_line_impl.hpp, which reads any JSON and says what is wrong with it.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "verify/trace_check/kinds.hpp"
#include "verify/trace_check/line.hpp"
#include "verify/trace_check/text_number.hpp"

namespace tps::check {

/// A place in a line. Each function takes what it names, or returns false and is of no further use.
class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  template <std::size_t N>
  bool take(const char (&literal)[N]) {
    constexpr std::size_t kLength = N - 1;
    if (static_cast<std::size_t>(end_ - at_) < kLength || std::memcmp(at_, literal, kLength) != 0)
      return false;
    at_ += kLength;
    return true;
  }
  bool at_end() const { return at_ == end_; }
  const char* place() const { return at_; }
  /// A text that has been taken before.
  bool take_again(std::string_view text) {
    if (static_cast<std::size_t>(end_ - at_) < text.size() || std::memcmp(at_, text.data(), text.size()) != 0)
      return false;
    at_ += text.size();
    return true;
  }

  /// What stands before the next quotation mark, which is taken, too; without anything that JSON escapes or
  /// that is no ASCII.
  bool take_string(std::string_view& text) {
    const char* const begin = at_;
    for (; at_ != end_ && *at_ != '"'; ++at_) {
      if (*at_ < ' ' || *at_ > '~' || *at_ == '\\') return false;
    }
    if (at_ == end_) return false;
    text = {begin, static_cast<std::size_t>(at_ - begin)};
    ++at_;
    return true;
  }

  /// A natural number of at most 18 digits, without zeros before it.
  bool take_natural(std::uint64_t& number) {
    const char* const begin = at_;
    number = 0;
    for (; at_ != end_ && *at_ >= '0' && *at_ <= '9'; ++at_)
      number = 10 * number + static_cast<std::uint64_t>(*at_ - '0');
    const auto length = at_ - begin;
    return length >= 1 && length <= 18 && (length == 1 || *begin != '0');
  }

  /// A normal double or 0 as append_hex spells it, and the quotation mark behind it.
  bool take_hex(double& number) {
    // Nothing is read behind a quotation mark, and every line has one.
    const char* p = at_;
    if (end_ - p < kLongestHex && std::memchr(p, '"', static_cast<std::size_t>(end_ - p)) == nullptr)
      return false;
    const bool negative = *p == '-';
    p += negative ? 1 : 0;
    if (p[0] != '0' || p[1] != 'x' || (p[2] != '1' && p[2] != '0')) return false;
    const bool is_normal = p[2] == '1';
    p += 3;
    std::uint64_t fraction = 0;
    if (*p == '.' && end_ - p > kDigits13 && take_thirteen(p + 1, fraction)) {
      p += kDigits13 + 1;
    } else if (*p == '.') {
      int shift = 52;
      for (++p; shift > 0; ++p) {
        const std::uint8_t digit = kDigits[static_cast<unsigned char>(*p)];
        if (digit > 15) break;
        shift -= 4;
        fraction |= std::uint64_t{digit} << static_cast<unsigned>(shift);
      }
      if (shift == 52) return false;
    }
    if (p[0] != 'p' || (p[1] != '+' && p[1] != '-')) return false;
    const bool is_below = p[1] == '-';
    p += 2;
    std::uint64_t exponent = 0;
    const char* const begin = p;
    for (; *p >= '0' && *p <= '9' && exponent < 10'000; ++p)
      exponent = 10 * exponent + static_cast<std::uint64_t>(*p - '0');
    if (p == begin || (*begin == '0' && p != begin + 1) || *p != '"') return false;
    at_ = p + 1;
    const std::uint64_t sign = negative ? std::uint64_t{1} << 63U : 0;
    if (!is_normal) {
      number = std::bit_cast<double>(sign);
      return fraction == 0 && exponent == 0 && !is_below;
    }
    if (exponent > (is_below ? 1022U : 1023U)) return false;
    const std::uint64_t biased = is_below ? 1023 - exponent : 1023 + exponent;
    number = std::bit_cast<double>(sign | biased << 52U | fraction);
    return true;
  }

 private:
  /// The value of eight hexadecimal digits, the first one the most significant; false where one is none.
  [[gnu::always_inline]] static bool eight_digits(const char* text, std::uint64_t& value) {
    constexpr std::uint64_t kOnes = 0x0101010101010101U;
    std::uint64_t x;
    std::memcpy(&x, text, sizeof x);
    const std::uint64_t letters = (x >> 6U) & kOnes;  // of '0' to '9' that bit is 0, of 'a' to 'f' 1
    const std::uint64_t nibbles = (x & (0x0f * kOnes)) + 9 * letters;
    const std::uint64_t above_nine = ((nibbles + 6 * kOnes) >> 4U) & kOnes;
    const bool are_digits =
        (nibbles & (0xf0 * kOnes)) == 0 && nibbles + '0' * kOnes + ('a' - '0' - 10) * above_nine == x;
    x = std::endian::native == std::endian::little ? __builtin_bswap64(nibbles) : nibbles;
    x = (x | (x >> 4U)) & 0x00ff00ff00ff00ffU;
    x = (x | (x >> 8U)) & 0x0000ffff0000ffffU;
    value = (x | (x >> 16U)) & 0xffffffffU;
    return are_digits;
  }
  /// A full fraction of a double, the digits of which fifteen in sixteen have.
  static bool take_thirteen(const char* text, std::uint64_t& fraction) {
    std::uint64_t first = 0, last = 0;  // eight, and eight of which three are among the first
    if (!eight_digits(text, first) || !eight_digits(text + 5, last)) return false;
    fraction = first << 20U | (last & 0xfffffU);
    return true;
  }
  static constexpr std::ptrdiff_t kDigits13 = 13;
  static constexpr std::ptrdiff_t kLongestHex = 26;  // -0x1.13 digits p±9999 and the mark
  static constexpr std::array<std::uint8_t, 256> kDigits = [] {
    std::array<std::uint8_t, 256> values{};
    values.fill(255);
    for (std::size_t n = 0; n < 16; ++n)
      values[static_cast<unsigned char>("0123456789abcdef"[n])] = static_cast<std::uint8_t>(n);
    return values;
  }();

  const char* at_;
  const char* end_;
};

/// Reads events. `Values` gives a number of a text, a time of a text and a particle of an id, or nothing.
template <typename Number, typename Values>
class OwnSpelling {
 public:
  OwnSpelling(const Values& values, std::string_view line) : values_(values), line_(line) {}

  /// Law: where it returns true the event is that of the line's JSON; what a kind of event has to have is not
  /// judged here.
  bool read(EventLine<Number>& e) {
    std::uint64_t k = 0;
    std::string_view kind;
    e.dt.emplace();
    if (!line_.take("{\"k\":") || !line_.take_natural(k) || !line_.take(",\"t\":\"") || !time(e) ||
        !line_.take(",\"dt\":\"") || !number(*e.dt) || !line_.take(",\"kind\":\"") ||
        !line_.take_string(kind) || !kind_named(kind, e.kind))
      return false;
    e.k = k;
    if (line_.take(",\"i\":") && !particle(e.i)) return false;
    if (line_.take(",\"j\":") && !particle(e.j)) return false;
    if (line_.take(",\"pre\":{") && !states(e)) return false;
    if (line_.take(",\"dp\":[\"") && !vector(e.dp.emplace())) return false;
    if (line_.take(",\"dp_stored\":[\"") && !vector(e.dp_stored.emplace())) return false;
    if (line_.take(",\"tether\":\"formed\"")) e.formed = true;
    if (line_.take(",\"tether\":\"broken\"")) {
      if (e.formed) return false;
      e.formed = false;
    }
    if (line_.take(",\"draw\":\"") && !(line_.take_hex(e.draw.emplace()) && *e.draw >= 0 && *e.draw < 1))
      return false;
    if (line_.take(",\"members\":[") && !members(e)) return false;
    return line_.take("}") && line_.at_end();
  }

 private:
  static bool kind_named(std::string_view name, Kind& kind) {
    for (const KindRow& known : kinds()) {
      if (known.name != name) continue;
      kind = known.kind;
      return true;
    }
    return false;
  }

  bool number(Number& x) {
    if constexpr (std::is_same_v<Number, double>) {
      return line_.take_hex(x) && values_.fits(x);
    } else {
      std::string_view text;
      return line_.take_string(text) && values_.number_if_any(text, x);
    }
  }
  bool time(EventLine<Number>& e) {
    std::string_view text;
    if (!line_.take_string(text) || !values_.instant_if_any(text, e.t)) return false;
    e.t_text = text;
    return true;
  }
  bool vector(Vec<Number>& v) {
    for (int n = 0; n < values_.dimension(); ++n) {
      if ((n > 0 && !line_.take(",\"")) || !number(v[static_cast<std::size_t>(n)])) return false;
    }
    return line_.take("]");
  }
  bool particle(int& index) {
    std::uint64_t id = 0;
    return line_.take_natural(id) && values_.particle_if_any(id, index);
  }
  bool members(EventLine<Number>& e) {
    do {
      int member = 0;
      if (!particle(member) || (!e.members.empty() && e.members.back() >= member)) return false;
      e.members.push_back(member);
    } while (line_.take(","));
    return line_.take("]");
  }

  /// "3":{"position":[…
  bool beginning(int& index) {
    return line_.take("\"") && particle(index) && line_.take("\":{\"position\":[\"");
  }
  /// …],"velocity":[…]}
  bool rest(Vec<Number>& velocity) {
    return line_.take(",\"velocity\":[\"") && vector(velocity) && line_.take("}");
  }
  /// Those before and those after, of the same particles in the same order. A position after is nearly always
  /// spelt as the one before: then it is not read twice.
  bool states(EventLine<Number>& e) {
    std::array<std::string_view, 2> spelt;
    e.involved.reserve(2);
    do {
      const std::size_t n = e.involved.size();
      InvolvedParticle<Number>& p = e.involved.emplace_back();
      if (!beginning(p.particle)) return false;
      const char* const place = line_.place();
      if (!vector(p.position_before.emplace())) return false;
      if (n < spelt.size()) spelt[n] = {place, static_cast<std::size_t>(line_.place() - place)};
      if (!rest(p.velocity_before.emplace())) return false;
    } while (line_.take(","));
    if (!e.index_involved() || !line_.take("},\"post\":{")) return false;
    for (std::size_t n = 0; n < e.involved.size(); ++n) {
      InvolvedParticle<Number>& p = e.involved[n];
      int index = -1;
      if ((n > 0 && !line_.take(",")) || !beginning(index) || index != p.particle) return false;
      if (n < spelt.size() && line_.take_again(spelt[n])) {
        p.position_after = p.position_before;
      } else if (!vector(p.position_after.emplace())) {
        return false;
      }
      if (!rest(p.velocity_after)) return false;
    }
    return line_.take("}");
  }

  const Values& values_;
  LineCursor line_;
};

}  // namespace tps::check
