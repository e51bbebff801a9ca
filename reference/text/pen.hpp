// Text at the end of a string, which is asked for room now and then and not at every piece.
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "reference/text/append_hex.hpp"

namespace tps {

/// Writes behind what a string holds; until it is gone the string is not to be used.
class Pen {
 public:
  explicit Pen(std::string& text) : text_(text) {
    const std::size_t written = text.size();
    text_.resize(written + kRoom);
    at_ = text_.data() + written;
    end_ = text_.data() + text_.size();
  }
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;
  ~Pen() { text_.resize(length()); }

  void put(char c) {
    need(1);
    *at_++ = c;
  }
  /// A literal.
  template <std::size_t N>
  void put(const char (&literal)[N]) {
    need(N);
    std::memcpy(at_, literal, N - 1);
    at_ += N - 1;
  }
  void put_text(std::string_view text) {
    need(text.size());
    std::memcpy(at_, text.data(), text.size());
    at_ += text.size();
  }
  /// Bytes that the string holds so far.
  std::size_t length() const { return static_cast<std::size_t>(at_ - text_.data()); }
  /// What stands in the string from a place on.
  void put_again(std::size_t place, std::size_t bytes) {
    need(bytes);
    std::memcpy(at_, text_.data() + place, bytes);
    at_ += bytes;
  }
  /// In decimal.
  void put_natural(std::integral auto n) {
    constexpr std::size_t kLongest = 24;  // 2^64 has 20 digits, and a sign
    need(kLongest);
    at_ = std::to_chars(at_, at_ + kLongest, n).ptr;
  }
  /// A number of any scalar as to_hex spells it.
  template <typename Scalar>
  void put_hex(const Scalar& x) {
    if constexpr (std::same_as<Scalar, double> || std::same_as<Scalar, float>) {
      need(kLongestHex);
      at_ = write_hex(at_, static_cast<double>(x));
    } else {
      put_text(to_hex(x));
    }
  }

  /// An exact sum as append_hex_sum spells it.
  template <typename Scalar>
  void put_hex_sum(const Scalar& hi, const Scalar& lo) {
    if constexpr (std::same_as<Scalar, double> || std::same_as<Scalar, float>) {
      need(kLongestHexSum);
      if (char* const end = write_hex_sum(at_, static_cast<double>(hi), static_cast<double>(lo))) {
        at_ = end;
        return;
      }
    }
    std::string spelt;
    append_hex_sum(spelt, hi, lo);
    put_text(spelt);
  }

 private:
  static constexpr std::size_t kRoom = 1024;

  void need(std::size_t bytes) {
    if (static_cast<std::size_t>(end_ - at_) < bytes) make_room(bytes);
  }
  void make_room(std::size_t bytes) {
    const std::size_t written = length();
    text_.resize(2 * written + bytes + kRoom);
    at_ = text_.data() + written;
    end_ = text_.data() + text_.size();
  }

  std::string& text_;
  char* at_;
  char* end_;
};

}  // namespace tps
