// Many cases of many laws, in rounds, until a count, a time or a signal.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "properties/check_law.hpp"

namespace tps::properties {

struct Plan {
  std::vector<const Law*> laws;
  std::uint64_t seed = 20260101;
  std::uint64_t first = 0;
  std::uint64_t count = 500;  ///< cases of each law, unless `stop` says so before
  bool bitwise = false;       ///< laws that say bitwise have to hold so
};

struct LawReport {
  const Law* law;
  Tally tally;
  std::optional<Finding> finding;  ///< the first; the law is not asked again, unless it is a refusal

  /// Broken, or failed: the law is asked no further case.
  bool is_broken() const { return finding && finding->outcome.kind != Outcome::Kind::refused; }
  bool is_done() const { return is_broken() || tally.skipped > 0; }
};

struct Exploration {
  std::string subject;
  Plan plan;
  std::uint64_t next;  ///< number of the first case that was not reached: where to go on
  std::vector<LawReport> laws;

  std::uint64_t held() const;
  std::vector<const Finding*> findings() const;
};

/// Every law in turn, a round of cases each, so that a stop finds all laws examined alike. `after_round` sees
/// the state after each; `stop` is asked before each case. Ends, too, where a signal came or the subject is
/// given up.
Exploration explore(Implementation& subject, const Plan& plan, const std::function<bool()>& stop,
                    const std::function<void(const Exploration&)>& after_round);

/// Laws whose id or number matches a pattern of the shell ("Eq4Laws.*"); all without patterns.
std::vector<const Law*> laws_matching(const std::vector<std::string>& patterns);

}  // namespace tps::properties
