// Certified answers to responses: eqs. (3)-(7) and chains of grouped collisions, each component enclosed
// between doubles. The numbers are the stored doubles, lifted exactly (docs/protocol.md, "Certified values").
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verify/operations/group_input.hpp"
#include "verify/operations/input.hpp"

namespace tps::certified {

/// A real number between two doubles: lo = hi where it is a double and proven so, adjacent doubles where it
/// is proven not to be one. Where balls cannot tell it from a double x, x lies strictly between lo
/// and hi; for x ≠ 0 these are its neighbours. Law: lo ≤ the real number ≤ hi, and lo ≤ nearest ≤ hi.
struct Enclosure {
  double lo, hi;
  double nearest;  ///< ties to even, infinity beyond the largest double, zero below half the smallest
  /// Whether `nearest` is proven. If not, 2^14 bits do not tell the number from zero, or from the middle of
  /// two doubles, and it is taken to be that.
  bool settled = true;
};

using EnclosedVector = std::vector<Enclosure>;

struct Response {
  /// Of tether_response "retract" or "revolve", of rough_impulse "sticks" or "slides"; empty for the others.
  std::string kind;
  /// |c_retract v_n| = tan θ |v_ŵ|, or both limits of friction equal: rounding decides, either kind is
  /// acceptable.
  bool boundary = false;
  std::map<std::string, EnclosedVector>
      values;  ///< by the keys of the operation's result: dp, v_A, v_load, …
};

/// Evaluates apply_impulse, collision_impulse, revolution_impulse, tether_response, load,
/// restitution_impulse or rough_impulse.
///
/// REQUIRES one of these, and input as read_words() and read_json() return it. Throws operations::NoAnswer
/// where eq. (5) is asked of a pair without tangential motion.
Response certified_response(operations::Op op, const operations::Input& input);

/// At a boundary, tether_response or rough_impulse with the other kind than `first` has; absent elsewhere,
/// and where v_ŵ = 0 leaves eq. (5) without an answer.
std::optional<Response> other_response(operations::Op op, const operations::Input& input,
                                       const Response& first);

struct GroupResponse {
  std::vector<EnclosedVector> loaded;      ///< velocities after the last load
  std::vector<EnclosedVector> restituted;  ///< after every tree has been unwound, root first
  bool boundary = false;                   ///< some tethering collision was at the boundary of its two kinds
};

/// Loads the collisions in their order, each between the bodies (groups or single) that hold i and j, then
/// unwinds. An infinite mass grounds what collides with it and joins no group.
/// Laws: (1) velocities are those of eqs. (4) to (7) and (3), nested; (2) momentum of finite masses is
/// conserved; (3) energy never rises, and comes back where every c is 1; (4) loads of different bodies may
/// come in any order.
///
/// REQUIRES vectors of one dimension, finite numbers in the ranges of the operations, i and j in range.
/// Throws operations::NoAnswer, naming the collision, where i and j are in one body, both bodies are
/// infinite, the positions coincide, or the bodies do not move towards the limit (inner: v_n > 0; outer: v_n
/// < 0; exactly).
GroupResponse certified_group(const operations::GroupInput& input);

}  // namespace tps::certified
