// A document taken apart strictly: known keys only, every value of its kind, messages that say where.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "reference/text/json_document.hpp"

namespace tps {

/// A value of a document with its place. Everything throws InputError where the value is not what is asked
/// for: with file, line, pointer, what was found and what is allowed.
class Field {
 public:
  /// The document itself; `value` and `file` must outlive this and all that is reached from it.
  Field(const JsonValue& value, const std::string& file) : value_(&value), file_(&file) {}
  Field(const JsonValue&, const std::string&&) = delete;
  Field(const JsonValue&&, const std::string&) = delete;
  Field(const JsonValue&&, const std::string&&) = delete;

  const JsonValue& json() const { return *value_; }

  /// Refuses keys that are neither in `needed` nor in `optional`, and objects that lack one of `needed`.
  void require_keys(std::initializer_list<std::string_view> needed,
                    std::initializer_list<std::string_view> optional = {}) const;

  bool has(std::string_view key) const { return value_->find(key) != nullptr; }
  /// REQUIRES that the key is there.
  Field at(std::string_view key) const;

  std::vector<Field> list() const;
  /// A list of exactly `size` entries.
  std::vector<Field> list_of(std::size_t size) const;
  /// The members of an object whose keys are data.
  std::vector<std::pair<std::string, Field>> members() const;

  bool is_null() const { return value_->is_null(); }
  const std::string& text() const;
  bool truth() const;
  std::uint64_t natural(std::uint64_t most) const;
  std::uint64_t natural() const { return natural(UINT64_MAX); }
  /// One of the words; its place in the list.
  std::size_t word(std::initializer_list<std::string_view> allowed) const;

  [[noreturn]] void refuse(std::string message) const;

 private:
  Field inside(const JsonValue& value, std::string_view step) const;

  const JsonValue* value_;
  const std::string* file_;
  std::string pointer_;
};

}  // namespace tps
