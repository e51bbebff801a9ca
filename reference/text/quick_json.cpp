#include "reference/text/quick_json.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tps {
namespace {

class QuickReader {
 public:
  QuickReader(std::string_view text, const JsonLimits& limits, std::size_t first_line)
      : at_(text.data()), end_(text.data() + text.size()), limits_(limits), line_(first_line) {}

  bool read_text(JsonValue& root) {
    if (!read_value(root, 0)) return false;
    skip_space();
    return at_ == end_;
  }

 private:
  void skip_space() {
    for (; at_ != end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r'); ++at_) {
      if (*at_ == '\n') ++line_;
    }
  }
  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }
  bool take_word(std::string_view word) {
    if (!std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  std::uint32_t line() const { return static_cast<std::uint32_t>(line_); }

  bool read_value(JsonValue& value, std::size_t depth) {
    skip_space();
    if (at_ == end_ || ++values_ > limits_.max_values) return false;
    value.line = line();
    switch (*at_) {
      case '{':
        return read_object(value.data.emplace<JsonValue::Object>(), depth);
      case '[':
        return read_array(value.data.emplace<JsonValue::Array>(), depth);
      case '"':
        return read_string(value.data.emplace<std::string>());
      case 't':
        value.data = true;
        return take_word("true");
      case 'f':
        value.data = false;
        return take_word("false");
      case 'n':
        return take_word("null");
      default:
        return read_number(value.data.emplace<JsonNumber>());
    }
  }

  bool read_object(JsonValue::Object& members, std::size_t depth) {
    if (depth >= limits_.max_depth) return false;
    ++at_;
    skip_space();
    if (take('}')) return true;
    do {
      skip_space();
      JsonMember& member = members.emplace_back();
      member.key_line = line();
      if (!read_string(member.key) || member.key.size() > limits_.max_key) return false;
      skip_space();
      if (!take(':') || !read_value(member.value, depth + 1)) return false;
      skip_space();
    } while (take(','));
    return take('}') && are_different(members);
  }

  bool read_array(JsonValue::Array& values, std::size_t depth) {
    if (depth >= limits_.max_depth) return false;
    ++at_;
    skip_space();
    if (take(']')) return true;
    do {
      if (!read_value(values.emplace_back(), depth + 1)) return false;
      skip_space();
    } while (take(','));
    return take(']');
  }

  bool read_string(std::string& string) {
    if (!take('"')) return false;
    const char* const begin = at_;
    while (at_ != end_ && *at_ >= ' ' && *at_ <= '~' && *at_ != '"' && *at_ != '\\') ++at_;
    string.assign(begin, at_);
    return take('"');
  }

  std::size_t take_digits() {
    const char* const begin = at_;
    while (at_ != end_ && *at_ >= '0' && *at_ <= '9') ++at_;
    return static_cast<std::size_t>(at_ - begin);
  }

  bool read_number(JsonNumber& number) {
    const char* const begin = at_;
    const bool negative = take('-');
    const bool leading_zero = at_ != end_ && *at_ == '0';
    const std::size_t digits = take_digits();
    if (digits == 0 || (leading_zero && digits > 1)) return false;
    bool is_integer = true;
    if (take('.')) {
      is_integer = false;
      if (take_digits() == 0) return false;
    }
    if (take('e') || take('E')) {
      is_integer = false;
      if (!take('+')) take('-');
      if (take_digits() == 0) return false;
    }
    return is_integer ? integer(number, begin, negative, digits) : decimal(number, begin);
  }

  bool integer(JsonNumber& number, const char* begin, bool negative, std::size_t digits) const {
    constexpr std::size_t kFitsIn64Bits = 18;
    if (digits > kFitsIn64Bits) return false;
    std::int64_t value = 0;
    std::from_chars(begin, at_, value);
    if (!negative) {
      number = natural_number(static_cast<std::uint64_t>(value));
    } else if (value != 0) {
      number = negative_number(value);
    } else {
      number.value = -0.0;
    }
    return true;
  }

  bool decimal(JsonNumber& number, const char* begin) const {
    const auto [behind, error] = std::from_chars(begin, at_, number.value);
    return error == std::errc() && behind == at_ && std::isfinite(number.value);
  }

  static bool are_different(const JsonValue::Object& members) {
    constexpr std::size_t kFew = 12;  // sorting a few names takes longer than comparing all of them
    if (members.size() > kFew) {
      std::vector<std::string_view> keys;
      for (const JsonMember& member : members) keys.push_back(member.key);
      std::sort(keys.begin(), keys.end());
      return std::adjacent_find(keys.begin(), keys.end()) == keys.end();
    }
    for (auto one = members.begin(); one != members.end(); ++one) {
      if (std::any_of(members.begin(), one, [&](const JsonMember& m) { return m.key == one->key; }))
        return false;
    }
    return true;
  }

  const char* at_;
  const char* end_;
  const JsonLimits& limits_;
  std::size_t line_;
  std::size_t values_ = 0;
};

template <typename Integer>
JsonNumber number_of(Integer value, bool convertible_back, JsonNumber::Integer sign,
                     std::uint64_t magnitude) {
  const auto nearest = static_cast<double>(value);
  const bool exact = convertible_back && static_cast<Integer>(nearest) == value;
  return {nearest, !exact, sign, magnitude};
}

}  // namespace

JsonNumber natural_number(std::uint64_t value) {
  return number_of(value, static_cast<double>(value) < 0x1p64, JsonNumber::Integer::natural, value);
}

JsonNumber negative_number(std::int64_t value) {
  return number_of(value, -0x1p63 <= static_cast<double>(value), JsonNumber::Integer::negative,
                   0 - static_cast<std::uint64_t>(value));
}

std::optional<JsonValue> quick_json(std::string_view text, const JsonLimits& limits, std::size_t first_line) {
  // A text that is refused at its end is read twice: that must not cost a large one twice its time.
  constexpr std::size_t kLongest = std::size_t{1} << 22;
  if (text.size() > std::min(limits.max_bytes, kLongest)) return std::nullopt;
  JsonValue root;
  if (!QuickReader(text, limits, first_line).read_text(root)) return std::nullopt;
  return root;
}

}  // namespace tps
