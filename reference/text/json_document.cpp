#include "reference/text/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reference/text/json_pointer.hpp"
#include "reference/text/json_syntax_message.hpp"
#include "reference/text/printable.hpp"
#include "reference/text/text_file.hpp"

namespace tps {
namespace {

constexpr std::size_t longest_quote = 60;

// What the parser has consumed: where it is, and how many line ends it has passed.
struct Progress {
  const char* begin;
  const char* at;
  std::size_t line_ends;

  // Line of the last consumed byte; a line end belongs to the line that it ends.
  std::size_t line() const { return line_ends + (at > begin && at[-1] == '\n' ? 0 : 1); }
};

// The input of the parser; counts line ends as it passes them.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Progress* progress) : at_(at), progress_(progress) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    if (*at_ == '\n') ++progress_->line_ends;
    progress_->at = ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Progress* progress_;
};

// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, Progress& progress, const std::string& name, const JsonLimits& limits,
              std::size_t first_line)
      : text_(text), progress_(progress), limits_(limits), first_line_(first_line), problems_(name) {}

  bool null() override { return add(std::monostate{}); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override {
    // The parser calls this for a leading minus only; "-0" is the double -0.
    if (value == 0) return add(JsonNumber{-0.0, false});
    return add_integer(value, -0x1p63 <= static_cast<double>(value), JsonNumber::Integer::negative,
                       0 - static_cast<std::uint64_t>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add_integer(value, static_cast<double>(value) < 0x1p64, JsonNumber::Integer::natural, value);
  }
  bool number_float(number_float_t value, const string_t& digits) override {
    // An integer with too many digits for 64 bits arrives here.
    const bool integer = digits.find_first_of(".eE") == std::string::npos;
    return add(JsonNumber{value, integer});
  }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in a text

  bool start_object(std::size_t) override { return open(JsonValue::Object()); }
  bool key(string_t& name) override {
    if (name.size() > limits_.max_key) {
      awaits_value_ = false;
      return fail(fmt::format("a key of {} bytes, \"{}\"; keys have at most {}", name.size(),
                              printable(name, longest_quote), limits_.max_key));
    }
    JsonMember member;
    member.key = std::move(name);
    member.key_line = line();
    awaits_value_ = true;
    std::get<JsonValue::Object>(open_.back().data).push_back(std::move(member));
    return true;
  }
  bool end_object() override {
    report_duplicates(std::get<JsonValue::Object>(open_.back().data));
    return close();
  }
  bool start_array(std::size_t) override { return open(JsonValue::Array()); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    return fail(json_syntax_message(error.id, error.what(), text_, consumed()));
  }

  JsonDocument take() { return {std::move(root_), std::move(problems_)}; }
  const InputProblems& problems() const { return problems_; }

 private:
  std::size_t consumed() const { return static_cast<std::size_t>(progress_.at - progress_.begin); }
  std::uint32_t line() const { return static_cast<std::uint32_t>(progress_.line() + first_line_ - 1); }

  template <typename Integer>
  bool add_integer(Integer value, bool convertible_back, JsonNumber::Integer sign, std::uint64_t magnitude) {
    const auto nearest = static_cast<double>(value);
    const bool exact = convertible_back && static_cast<Integer>(nearest) == value;
    return add(JsonNumber{nearest, !exact, sign, magnitude});
  }

  template <typename Data>
  JsonValue make(Data&& data) const {
    JsonValue value;
    value.data = std::forward<Data>(data);
    value.line = line();
    return value;
  }

  template <typename Data>
  bool add(Data&& data) {
    if (++values_ > limits_.max_values) {
      return fail(fmt::format("more than {} values, the most that is read", limits_.max_values));
    }
    place(make(std::forward<Data>(data)));
    return true;
  }

  template <typename Container>
  bool open(Container container) {
    if (open_.size() >= limits_.max_depth) {
      return fail(fmt::format("lists and objects inside each other more than {} deep", limits_.max_depth));
    }
    if (++values_ > limits_.max_values) {
      return fail(fmt::format("more than {} values, the most that is read", limits_.max_values));
    }
    open_.push_back(make(std::move(container)));
    awaits_value_ = false;
    return true;
  }
  bool close() {
    JsonValue value = std::move(open_.back());
    open_.pop_back();
    place(std::move(value));
    return true;
  }

  // Puts a finished value where it belongs: into the innermost open container.
  void place(JsonValue value) {
    awaits_value_ = false;
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (auto* array = std::get_if<JsonValue::Array>(&open_.back().data)) {
      array->push_back(std::move(value));
    } else {
      std::get<JsonValue::Object>(open_.back().data).back().value = std::move(value);
    }
  }

  // Pointer of the `depth` outermost open containers' current members.
  std::string pointer(std::size_t depth) const {
    std::string text;
    for (std::size_t k = 0; k < depth; ++k) {
      if (const JsonValue::Array* array = open_[k].array()) {
        text += fmt::format("/{}", array->size());
      } else if (const JsonValue::Object* object = open_[k].object(); !object->empty()) {
        text += fmt::format("/{}", escape_pointer_key(object->back().key));
      }
    }
    return text;
  }

  void report_duplicates(const JsonValue::Object& members) {
    std::vector<const JsonMember*> sorted;
    for (const JsonMember& member : members) sorted.push_back(&member);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const JsonMember* a, const JsonMember* b) { return a->key < b->key; });
    for (std::size_t k = 1; k < sorted.size(); ++k) {
      if (sorted[k]->key != sorted[k - 1]->key) continue;
      problems_.add(sorted[k]->key_line, pointer(open_.size() - 1),
                    fmt::format("key \"{}\" stands twice, here and in line {}; keep one",
                                printable(sorted[k]->key, longest_quote), sorted[k - 1]->key_line));
    }
  }

  bool fail(std::string message) {
    // Between two members of an object the place is the object, not the member that is behind us.
    const bool between_members = !open_.empty() && open_.back().object() != nullptr && !awaits_value_;
    problems_.add(line(), pointer(open_.size() - (between_members ? 1 : 0)), std::move(message));
    return false;
  }

  std::string_view text_;
  const Progress& progress_;
  const JsonLimits& limits_;
  std::size_t first_line_;
  InputProblems problems_;
  JsonValue root_;
  std::vector<JsonValue> open_;
  std::size_t values_ = 0;
  bool awaits_value_ = false;  // the last thing read was a key
};

void refuse_what_is_no_json_text(std::string_view text, const std::string& name, const JsonLimits& limits) {
  const auto fail = [&](std::string message) {
    throw InputError(std::vector<InputProblem>{{name, 1, "", std::move(message)}});
  };
  if (text.size() > limits.max_bytes) {
    fail(fmt::format("{} bytes; at most {} are read", text.size(), limits.max_bytes));
  }
  if (text.starts_with("\xEF\xBB\xBF") || text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) {
    fail("starts with a byte order mark; save the file as UTF-8 without one");
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    // The library would take it for the end of the text.
    fail(fmt::format("the byte at offset {} is NUL; this is no text", nul));
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    fail("is empty; a JSON document is needed");
}

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
  const Object* members = object();
  if (members == nullptr) return nullptr;
  const auto member =
      std::find_if(members->begin(), members->end(), [&](const JsonMember& m) { return m.key == key; });
  return member == members->end() ? nullptr : &member->value;
}

JsonDocument parse_json(std::string_view text, const std::string& name, const JsonLimits& limits,
                        std::size_t first_line) {
  refuse_what_is_no_json_text(text, name, limits);
  Progress progress{text.data(), text.data(), 0};
  TreeBuilder builder(text, progress, name, limits, first_line);
  const bool whole =
      nlohmann::json::sax_parse(CountingIterator(text.data(), &progress),
                                CountingIterator(text.data() + text.size(), &progress), &builder);
  if (!whole) builder.problems().throw_if_any();
  return builder.take();
}

JsonDocument parse_json_file(const std::string& path, const std::string& remedy, const JsonLimits& limits) {
  return parse_json(read_text_file(path, limits.max_bytes, remedy), display_name(path), limits);
}

}  // namespace tps
