// What became of one case of a law.
#pragma once

#include <string>

namespace tps::properties {

struct Outcome {
  enum class Kind {
    holds,
    rounding,  ///< holds to rounding where the law says bitwise
    outside,   ///< the law says nothing about this case, or the operation has no answer to it
    refused,   ///< the operation has an answer, and the implementation gives none
    skipped,   ///< the implementation does not offer the operation
    broken,
    failed,  ///< the implementation crashed, hung or broke the protocol
  };
  Kind kind = Kind::holds;
  std::string why;  ///< empty where it holds

  bool is_finding() const { return kind == Kind::broken || kind == Kind::failed || kind == Kind::refused; }
};

inline Outcome outside(std::string why) {
  return {Outcome::Kind::outside, std::move(why)};
}
inline Outcome broken(std::string why) {
  return {Outcome::Kind::broken, std::move(why)};
}

/// Holds in its last bits only.
inline Outcome to_rounding(std::string why) {
  return {Outcome::Kind::rounding, std::move(why)};
}

/// The first that does not hold; if all do, the first that does so to rounding only.
template <typename... More>
Outcome all_of(Outcome first, More... more) {
  if constexpr (sizeof...(More) > 0) {
    if (first.kind != Outcome::Kind::holds && first.kind != Outcome::Kind::rounding) return first;
    Outcome rest = all_of(std::move(more)...);
    return rest.kind == Outcome::Kind::holds ? first : rest;
  } else {
    return first;
  }
}

}  // namespace tps::properties
