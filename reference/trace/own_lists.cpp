#include "reference/trace/own_lists.hpp"

#include <cstdint>
#include <utility>

namespace tps {
namespace {

/// A place in a line. Each function takes what it names, or returns false and is of no further use.
class Cursor {
 public:
  explicit constexpr Cursor(std::string_view text) : text_(text) {}

  std::size_t place() const { return at_; }

  bool take(std::string_view literal) {
    if (!text_.substr(at_).starts_with(literal)) return false;
    at_ += literal.size();
    return true;
  }

  /// The id of a particle, in decimal.
  constexpr bool take_id(std::int32_t& id) {
    constexpr std::size_t kMostDigits = 9;  // so that it is one; longer ones are left to the other reader
    const std::size_t begin = at_;
    id = 0;
    for (; at_ < text_.size() && is_decimal(text_[at_]); ++at_) {
      if (at_ - begin == kMostDigits) return false;
      id = 10 * id + (text_[at_] - '0');
    }
    const std::size_t digits = at_ - begin;
    return digits == 1 || (digits > 1 && text_[begin] != '0');
  }

  /// A hexadecimal float in quotation marks, of as many digits as the widest scalar has.
  bool take_hex(Hex& number) {
    constexpr std::size_t kLongest = 100;
    if (!take("\"")) return false;
    const std::size_t begin = at_;
    const std::string_view text = text_.substr(begin, kLongest);
    std::size_t n = text.starts_with('-') ? 1 : 0;
    if (text.substr(n, 2) != "0x") return false;
    n += 2;
    if (!skip(text, n, is_hexadecimal)) return false;
    if (n < text.size() && text[n] == '.' && !skip(text, ++n, is_hexadecimal)) return false;
    if (n + 1 >= text.size() || text[n] != 'p' || (text[n + 1] != '+' && text[n + 1] != '-')) return false;
    n += 2;
    const std::size_t exponent = n;
    if (!skip(text, n, is_decimal) || n - exponent > 5) return false;
    if (n >= text.size() || text[n] != '"') return false;
    number.assign(text.substr(0, n));
    at_ = begin + n + 1;
    return true;
  }

  /// ["…",…] of `least` to `most` numbers.
  bool take_numbers(HexVector& numbers, std::size_t least, std::size_t most) {
    if (!take("[")) return false;
    do {
      numbers.emplace_back();
      if (numbers.size() > most || !take_hex(numbers.back())) return false;
    } while (take(","));
    return numbers.size() >= least && take("]");
  }

 private:
  static constexpr bool is_decimal(char c) { return c >= '0' && c <= '9'; }
  static bool is_hexadecimal(char c) { return is_decimal(c) || (c >= 'a' && c <= 'f'); }

  /// Goes past characters of a kind. @return whether there are any
  static bool skip(std::string_view text, std::size_t& n, bool (*is_kind)(char)) {
    const std::size_t begin = n;
    while (n < text.size() && is_kind(text[n])) ++n;
    return n > begin;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

constexpr bool is_id(std::string_view text) {
  std::int32_t id = 0;
  return Cursor(text).take_id(id);
}
// Evaluated by the compiler, which refuses what overflows.
static_assert(is_id("0") && is_id("10") && is_id("999999999"));
static_assert(!is_id("") && !is_id("-1") && !is_id("07") && !is_id("9999999999") &&
              !is_id("4294967296429496"));

bool take_particle(Cursor& cursor, StateData::Particle& p) {
  HexVector clock;
  if (!cursor.take("{\"id\":") || !cursor.take_id(p.id)) return false;
  if (!cursor.take(",\"position\":") || !cursor.take_numbers(p.position, 2, 3)) return false;
  if (!cursor.take(",\"velocity\":") || !cursor.take_numbers(p.velocity, 2, 3)) return false;
  if (cursor.take(",\"spin\":") && (!cursor.take_numbers(p.spin, 1, 3) || p.spin.size() == 2)) return false;
  if (!cursor.take(",\"clock\":") || !cursor.take_numbers(clock, 2, 2) || !cursor.take("}")) return false;
  p.clock = {std::move(clock[0]), std::move(clock[1])};
  return true;
}

bool take_responded(Cursor& cursor, StateData::Responded& r) {
  if (!cursor.take("[") || !cursor.take_id(r.first) || !cursor.take(",") || !cursor.take_id(r.second))
    return false;
  r.outer = cursor.take(",\"outer\"]");
  return r.outer || cursor.take(",\"inner\"]");
}

/// Takes the list behind `key` out of a line. @return whether it is there and whole
template <typename Item>
bool take_out(std::string_view key, bool (*take_item)(Cursor&, Item&), std::string_view& line,
              std::vector<Item>& items, std::string& rest) {
  const std::size_t begin = line.find(key);
  if (begin == line.npos) return false;
  const std::size_t list = begin + key.size();
  Cursor cursor(line.substr(list));
  if (!cursor.take("]")) {
    do {
      items.emplace_back();
      if (!take_item(cursor, items.back())) return false;
    } while (cursor.take(","));
    if (!cursor.take("]")) return false;
  }
  rest.append(line.substr(0, list)).append("]");
  line.remove_prefix(list + cursor.place());
  return true;
}

}  // namespace

std::optional<StateWithoutLists> without_own_lists(std::string_view line) {
  StateWithoutLists state;
  if (!take_out(",\"particles\":[", take_particle, line, state.particles, state.rest)) return std::nullopt;
  if (!take_out(",\"responded\":[", take_responded, line, state.responded, state.rest)) return std::nullopt;
  state.rest.append(line);
  return state;
}

}  // namespace tps
