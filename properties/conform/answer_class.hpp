// What became of an answer (docs/conform.md). A percentage says less than any of these words.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace tps::properties::conform {

/// From best to worst.
enum class Class {
  right,          ///< correctly rounded, or the law holds as it is worded
  rounding,       ///< within what a stable evaluation in the subject's precision reaches
  not_bitwise,    ///< a symmetry that holds to rounding only
  other_reading,  ///< right by another reading where the paper is silent
  beyond,         ///< rounding decides here: no evaluation in this precision can be sure of the answer
  worse,  ///< within what the printed formula loses, and a stable one keeps; or its products leave the range
  refused,  ///< there is an answer, and the subject gives none
  wrong,
};

constexpr std::size_t kClasses = 8;

struct ClassFacts {
  Class which;
  std::string_view name;   ///< as in reports and profiles
  std::string_view brief;  ///< as at the head of a column
};

constexpr std::array<ClassFacts, kClasses> kClassFacts{{
    {Class::right, "RIGHT", "right"},
    {Class::rounding, "ROUNDING", "rounding"},
    {Class::not_bitwise, "NOT BITWISE", "bitwise"},
    {Class::other_reading, "OTHER READING", "reading"},
    {Class::beyond, "BEYOND ITS PRECISION", "beyond"},
    {Class::worse, "WORSE THAN STABLE", "worse"},
    {Class::refused, "REFUSED", "refused"},
    {Class::wrong, "WRONG", "WRONG"},
}};

constexpr std::size_t index_of(Class c) {
  return static_cast<std::size_t>(c);
}
constexpr std::string_view name(Class c) {
  return kClassFacts[index_of(c)].name;
}
constexpr std::optional<Class> class_named(std::string_view text) {
  for (const ClassFacts& facts : kClassFacts) {
    if (facts.name == text) return facts.which;
  }
  return std::nullopt;
}

}  // namespace tps::properties::conform
