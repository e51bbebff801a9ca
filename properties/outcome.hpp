// What became of one case of a law.
#pragma once

#include <string>

namespace tps::properties {

struct Outcome {
  enum class Kind {
    holds,
    outside,  ///< the law says nothing about this case, or the operation has no answer to it
    skipped,  ///< the implementation does not offer the operation
    broken,
    failed,  ///< the implementation crashed, hung or broke the protocol
  };
  Kind kind = Kind::holds;
  std::string why;  ///< empty where it holds

  bool is_finding() const { return kind == Kind::broken || kind == Kind::failed; }
};

inline Outcome outside(std::string why) {
  return {Outcome::Kind::outside, std::move(why)};
}
inline Outcome broken(std::string why) {
  return {Outcome::Kind::broken, std::move(why)};
}

/// The first that does not hold.
template <typename... More>
Outcome all_of(Outcome first, More... more) {
  if constexpr (sizeof...(More) > 0) {
    return first.kind == Outcome::Kind::holds ? all_of(std::move(more)...) : first;
  } else {
    return first;
  }
}

}  // namespace tps::properties
