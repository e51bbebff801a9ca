// What the trace check found.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/operations/catalogue.hpp"
#include "verify/trace_check/rule.hpp"

namespace tps::check {

enum class Outcome { violated, undecided };

/// A step with inputs that `tps eval` and `tps vectors` can replay: a case of one operation.
struct Replay {
  operations::Op op;
  std::string in;  ///< the operation's "in", as JSON
};

/// One step that is not as it should be.
struct Finding {
  Rule rule = Rule::schema;
  Outcome outcome = Outcome::violated;
  std::uint64_t line = 0;   ///< of the trace
  std::uint64_t event = 0;  ///< its number, 0 where it is none
  std::string t;            ///< when, on the scene's clock
  std::vector<std::int32_t> particles;
  std::string message;        ///< what was found, what is allowed
  std::string equation;       ///< "(4)", "(2)"; empty where none is concerned
  std::string reading;        ///< of the paper that would explain it: "D9: …"; empty where none is known
  std::optional<double> off;  ///< in ulps of the quantity
  std::optional<double> allowed;
  std::optional<Replay> replay;
};

struct RuleResult {
  Rule rule = Rule::schema;
  std::uint64_t passed = 0;
  std::uint64_t violated = 0;
  std::uint64_t undecided = 0;
  std::string not_judged;   ///< why the rule, or a part of it, could not be judged; empty if it could
  std::uint64_t vague = 0;  ///< steps where the trace is too uncertain to judge it
  double worst = 0;         ///< the largest share of its bound that a passing step used up
  double worst_off = 0;     ///< the same in ulps
  double worst_allowed = 0;
};

/// A signed sum of residuals: the mean of what is rounded correctly is zero within its standard error.
struct ResidualSum {
  std::string of;  ///< the quantity
  std::uint64_t count = 0;
  double mean = 0;  ///< in ulps
  double standard_error = 0;
  double independent = 0;  ///< residuals, those of like events counted once
};

struct CheckReport {
  std::string file, title, scalar, timing;
  bool minimal = false;  ///< velocities only: positions are the checker's own
  std::uint64_t lines = 0, events = 0, states = 0;
  std::uint64_t segments = 0;  ///< in which it was judged, each from a full state (docs/check.md, "Segments")
  std::size_t particles = 0;
  std::string end;           ///< the reason the trace gives; empty if it gives none
  bool interrupted = false;  ///< the check was, before the trace's end
  double tolerance = 1;
  double seconds = 0;
  std::array<RuleResult, kRules> rules;
  std::vector<Finding> findings;  ///< in the order of the trace, max_reports for each rule
  std::vector<ResidualSum> sums;
  std::vector<std::string>
      notes;  ///< on the trace as a whole: how it was read, what may explain its findings
  std::uint64_t certified_comparisons = 0;  ///< orders that integers or double words had to decide

  const RuleResult& of(Rule rule) const { return rules[static_cast<std::size_t>(rule)]; }
  std::uint64_t violated() const;
  std::uint64_t undecided() const;
  /// Nothing is violated.
  bool conforming() const { return violated() == 0; }
  /// Nothing is violated, but too much is left open to say so: more undecided steps than one in a hundred,
  /// and more than two.
  bool inconclusive() const;
  /// Nothing is violated, but a rule about steps could not judge some of them (bias is about the whole run).
  bool partial() const;
};

std::string report_text(const CheckReport& report);
std::string report_json(const CheckReport& report);
/// One test case a rule, for CI systems.
std::string report_junit(const CheckReport& report);

}  // namespace tps::check
