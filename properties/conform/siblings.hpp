// Questions that differ in one number: what shows whether an answer that is remembered is remembered by all
// that it depends on.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/operations/catalogue.hpp"

namespace tps::properties::conform {

/// A stratum that is in no file: it stands behind the first one of each operation.
constexpr const char* kSiblings = "siblings";

inline std::string siblings_name(operations::Op op) {
  return std::string(operations::name(op)) + "." + kSiblings;
}

struct Sibling {
  std::string changed;  ///< "L", "u_A/0", "second/v_B/1"
  nlohmann::ordered_json in;
};

/// One for each finite number of a question: with seven eighths of it, an eighth where it is 0, and nothing
/// else changed (none for 5e-324, which that rounds to). Not each of them is a question. Law: (1) no two are
/// equal, and none is equal to `in`.
std::vector<Sibling> siblings_of(const nlohmann::ordered_json& in);

}  // namespace tps::properties::conform
