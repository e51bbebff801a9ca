// Replies of an implementation to the cases of known-answer files.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>

#include "verify/vectors/known_answer.hpp"

namespace tps::cli {

/// Replies by the number of the case in the files as given (seq), or by its id; and the operations that the
/// answer to hello names, if one is there.
struct Replies {
  std::unordered_map<std::string, vectors::Json> by_case;
  std::set<std::string> offered;

  /// Whether a reply is to the case by its id.
  bool names(const vectors::Json& known) const;
  /// The reply to a case; null where there is none.
  const vectors::Json* find(const vectors::Json& known, std::uint64_t seq) const;
};

/// Reads one reply a line, "-" being standard input. THROWS InputError where a line is none.
Replies read_replies(const std::string& path);

}  // namespace tps::cli
