// An input that could be read and has no answer.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/text/input_error.hpp"

namespace tps::operations {

/// Why the equations have no answer: eq. (5) is 0/0, the scalar does not hold a number, a group's collision
/// is none. It knows no file; who has read the input makes an InputError of it.
class NoAnswer : public std::runtime_error {
 public:
  /// `pointer`: the part of the input that is to blame; the whole, if empty.
  explicit NoAnswer(const std::string& reason, std::string pointer = "")
      : std::runtime_error(reason), pointer_(std::move(pointer)) {}

  /// Where the input stands at `place` of `file`.
  InputError in(const std::string& file, std::size_t line, const std::string& place) const {
    return InputError({{file, line, place + pointer_, what()}});
  }

 private:
  std::string pointer_;
};

/// Of eq. (5) for a pair without a velocity across its axis.
inline constexpr const char* kNothingAcross =
    "v_ŵ, the velocity across û, is zero, so û_revolve is 0/0 and eq. (5) has no answer; tether_response "
    "retracts such "
    "a pair";

}  // namespace tps::operations
