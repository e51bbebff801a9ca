#include "verify/operations/input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reference/text/input_error.hpp"
#include "reference/text/json_number.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/printable.hpp"
#include "reference/text/typed_number.hpp"
#include "verify/operations/domain.hpp"

namespace tps::operations {
namespace {

/// Collects what was read, and everything that is wrong with it.
class Reader {
 public:
  Reader(std::string_view name, const std::vector<std::string>& keys, const std::string& source)
      : name_(name), keys_(keys), problems_(source) {}
  Reader(const Operation& operation, const std::string& source)
      : Reader(operation.name, operation.keys, source) {
    needs_axis_ = operation.needs_axis;
  }

  /// Takes the numbers of one key.
  void take(const std::string& key, const std::vector<double>& numbers, std::size_t line,
            const std::string& pointer) {
    if (!known(key, line, pointer)) return;
    if (!input_.values.emplace(key, numbers).second) {
      problems_.add(line, pointer, fmt::format("{} is given twice; give it once", key));
      return;
    }
    check(key, numbers, line, pointer);
  }

  /// Whether the operation has that key; says so if not.
  bool known(const std::string& key, std::size_t line, const std::string& pointer) {
    if (std::find(keys_.begin(), keys_.end(), key) != keys_.end()) return true;
    problems_.add(line, pointer,
                  fmt::format("{} has no key {}{} It takes {}", name_, key, did_you_mean(key, keys_),
                              fmt::join(keys_, ", ")));
    return false;
  }

  void problem(std::size_t line, const std::string& pointer, std::string message) {
    problems_.add(line, pointer, std::move(message));
  }
  /// A key that is there but could not be read is not missing as well.
  void unreadable(const std::string& key) { input_.values.emplace(key, std::vector<double>{}); }

  /// What needs all keys: completeness, equal masses of infinity, an axis. The place is that of the object.
  Input finish(std::size_t line = 0, const std::string& place = "") {
    for (const std::string& key : keys_) {
      if (!input_.values.contains(key)) {
        problems_.add(line, place,
                      fmt::format("{} needs {}; it takes {}", name_, key, fmt::join(keys_, ", ")));
      }
    }
    problems_.throw_if_any();
    const auto& v = input_.values;
    if (v.contains("m_A") && std::isinf(v.at("m_A")[0]) && std::isinf(v.at("m_B")[0])) {
      problems_.add(line, place,
                    "m_A and m_B are both inf; two infinite masses never interact, make one finite");
    }
    check_spins(line, place);
    if (needs_axis_ && v.at("u_A") == v.at("u_B")) {
      problems_.add(
          line, place,
          "u_A and u_B are the same point, so û = (u_B - u_A)/|u_B - u_A| is not defined; move one");
    }
    problems_.throw_if_any();
    return input_;
  }

 private:
  void check_spins(std::size_t line, const std::string& place) {
    const std::size_t components = input_.dimension == 2 ? 1 : 3;
    for (const auto& [key, numbers] : input_.values) {
      if (domain_of(key) != Domain::spin || numbers.size() == components) continue;
      problems_.add(line, place,
                    fmt::format("{} has {} components; a spin is one number in the plane, three in space",
                                key, numbers.size()));
    }
  }

  void check(const std::string& key, const std::vector<double>& numbers, std::size_t line,
             const std::string& pointer) {
    const auto refuse = [&](double found, const char* allowed) {
      problems_.add(line, pointer, fmt::format("{} is {}; {}", key, found, allowed));
    };
    const Domain domain = domain_of(key);
    const bool is_vector = domain == Domain::vector || domain == Domain::direction;
    if (is_vector) check_dimension(key, numbers, line, pointer);
    if (is_vector || domain == Domain::spin) {
      for (const double x : numbers) {
        if (!std::isfinite(x)) return refuse(x, "components must be finite");
      }
      const bool has_length = numbers.size() == 2 || numbers.size() == 3;
      if (domain == Domain::direction && has_length) check_length(key, numbers, line, pointer);
      return;
    }
    if (numbers.size() != 1) {
      problems_.add(line, pointer,
                    fmt::format("{} has {} components; it must be one number", key, numbers.size()));
      return;
    }
    const double x = numbers[0];
    const Range range = range_of(key, domain);
    if (!(x >= range.least && x <= range.most)) refuse(x, range.allowed);
  }

  /// The numbers of a domain, and how messages put it.
  struct Range {
    double least, most;
    const char* allowed;
  };
  static Range range_of(const std::string& key, Domain domain) {
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();  // above 0
    constexpr double kMost = std::numeric_limits<double>::max();
    switch (domain) {
      case Domain::length:
        return {kLeast, kMost,
                key == "L" ? "a limiting distance must be finite and above 0"
                           : "a radius must be finite and above 0"};
      case Domain::rate:
        return {kLeast, kMost, "a rate must be finite and above 0"};
      case Domain::not_negative:
        return {0, kMost, "it must be finite and at least 0"};
      case Domain::mass:
        return {kLeast, HUGE_VAL, "a mass must be above 0, or inf"};
      case Domain::coefficient:
        return {0, 1, "a coefficient must be in [0, 1]"};
      case Domain::signed_coefficient:
        return {-1, 1, "tangential restitution must be in [-1, 1]"};
      case Domain::angle:
        return {1e-6, 90 - 1e-6, "θ_revolve must be in [1e-6, 89.999999] degrees"};
      default:
        return {-kMost, kMost, "it must be finite"};
    }
  }

  /// Scenes ask for 2^-50; a direction rounded to a half-precision number is one, too.
  void check_length(const std::string& key, const std::vector<double>& numbers, std::size_t line,
                    const std::string& pointer) {
    const double length = numbers.size() == 2 ? std::hypot(numbers[0], numbers[1])
                                              : std::hypot(numbers[0], numbers[1], numbers.at(2));
    if (std::fabs(length - 1) <= 0x1p-10) return;
    problems_.add(line, pointer,
                  fmt::format("{} has the length {}; a direction has length 1, to 2^-10", key, length));
  }

  void check_dimension(const std::string& key, const std::vector<double>& numbers, std::size_t line,
                       const std::string& pointer) {
    const int found = static_cast<int>(numbers.size());
    if (found != 2 && found != 3) {
      problems_.add(line, pointer, fmt::format("{} has {} components; a vector has 2 or 3", key, found));
    } else if (input_.dimension == 0) {
      input_.dimension = found;
    } else if (found != input_.dimension) {
      problems_.add(
          line, pointer,
          fmt::format("{} has {} components where the vectors before it have {}; all must have the same", key,
                      found, input_.dimension));
    }
  }

  std::string_view name_;
  const std::vector<std::string>& keys_;
  bool needs_axis_ = false;
  InputProblems problems_;
  Input input_;
};

std::optional<std::vector<double>> json_numbers(const JsonValue& value) {
  std::vector<double> numbers;
  if (const std::optional<double> one = json_number(value)) return std::vector<double>{*one};
  if (value.array() == nullptr) return std::nullopt;
  for (const JsonValue& component : *value.array()) {
    const std::optional<double> x = json_number(component);
    if (!x) return std::nullopt;
    numbers.push_back(*x);
  }
  return numbers;
}

/// What of a value is no number, itself or the first of its components that is none; and what is read.
std::string why_no_numbers(const JsonValue& value) {
  const std::string allowed =
      R"(a number, a string with a hexadecimal float or "inf", or a list of 2 or 3 of them)";
  const JsonValue* bad = &value;
  std::string which;
  if (value.array() != nullptr) {
    const auto found = std::find_if(value.array()->begin(), value.array()->end(),
                                    [](const JsonValue& x) { return !json_number(x).has_value(); });
    bad = &*found;
    which = fmt::format("component {} ", found - value.array()->begin());
  }
  if (bad->string() == nullptr)
    return which.empty() ? "must be " + allowed : which + "is no number; allowed: " + allowed;
  const std::string& text = *bad->string();
  const bool is_hex = parse_hex_float(text).verdict == HexFloat::Verdict::not_a_double;
  return fmt::format("{}is \"{}\", {}; allowed: {}", which, printable(text, 60),
                     is_hex ? "a number that no double has" : "which is no hexadecimal float", allowed);
}

Input read_members(Reader reader, const JsonValue& object, const std::string& place,
                   std::string_view other_key) {
  if (object.object() == nullptr) {
    reader.problem(object.line, place, "must be an object of numbers and vectors such as {\"u_A\":[0,0],…}");
    return reader.finish(object.line, place);
  }
  for (const JsonMember& member : *object.object()) {
    if (member.key == other_key) continue;
    const std::string pointer = place + "/" + escape_pointer_key(member.key);
    if (const std::optional<std::vector<double>> numbers = json_numbers(member.value)) {
      reader.take(member.key, *numbers, member.key_line, pointer);
    } else if (reader.known(member.key, member.key_line, pointer)) {
      reader.problem(member.value.line, pointer, why_no_numbers(member.value));
      reader.unreadable(member.key);
    }
  }
  return reader.finish(object.line, place);
}

}  // namespace

Input read_words(const Operation& operation, const std::vector<std::string>& words,
                 const std::string& source) {
  Reader reader(operation, source);
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      reader.problem(0, "", fmt::format("'{}' is not key=value, such as u_A=0,0 or L=1", word));
      continue;
    }
    const std::string key = word.substr(0, equals);
    std::vector<double> numbers;
    bool readable = true;
    for (std::size_t begin = equals + 1; begin <= word.size();) {
      const std::size_t comma = std::min(word.find(',', begin), word.size());
      const std::string text = word.substr(begin, comma - begin);
      const TypedNumber number = typed_number(text);
      if (number.value) {
        numbers.push_back(*number.value);
      } else {
        reader.problem(0, "", fmt::format("{}: '{}' {}", key, text, number.reason));
        readable = false;
      }
      begin = comma + 1;
    }
    if (readable) {
      reader.take(key, numbers, 0, "");
    } else if (reader.known(key, 0, "")) {
      reader.unreadable(key);
    }
  }
  return reader.finish();
}

Input read_value(const Operation& operation, const JsonValue& object, const Place& place) {
  return read_members(Reader(operation, place.source), object, place.pointer, "");
}

Input read_object(std::string_view name, const std::vector<std::string>& keys, const JsonValue& object,
                  const Place& place, std::string_view other_key) {
  return read_members(Reader(name, keys, place.source), object, place.pointer, other_key);
}

}  // namespace tps::operations
