// What was asked of an implementation and what became of it: a table with a row for each operation and
// hazard.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "properties/conform/grade.hpp"

namespace tps::properties::conform {

/// A case that shows what a class means here.
struct Example {
  Class which = Class::right;
  std::string id;                     ///< of the known answer, or the law and its case
  std::string why;                    ///< what was found, what is right
  std::vector<std::string> commands;  ///< that show the right answer
  std::string in;                     ///< the question as JSON; empty for a run
  double units = 0, cond = 0;
  std::string found = {},
              right = {};  ///< answers as JSON, "t" or "dp" of them; empty where there is none to show
};

struct Row {
  std::string area;    ///< equations, timing, order, response, grouping, engine, whole runs
  std::string name;    ///< "block_time.graze", the id of a law, "run.revolve"
  std::string of;      ///< the operation, "laws of (2)", "runs"
  std::string hazard;  ///< the stratum, the law's number, the feature
  std::string page;
  std::array<std::uint64_t, kClasses> counts{};
  std::optional<std::uint64_t> reference =
      {};  ///< how many the reference in the same numbers has right or to rounding
  double worst_units = 0, worst_cond = 0;
  std::array<std::optional<Example>, kClasses> examples =
      {};                                                ///< of each class from NOT BITWISE on, the first
  std::map<std::string, std::uint64_t> hypotheses = {};  ///< what explains how many of the wrong answers

  std::uint64_t asked() const;
  std::uint64_t of_class(Class c) const { return counts[index_of(c)]; }
  const std::optional<Example>& example_of(Class c) const { return examples[index_of(c)]; }
  /// That of the worst class; null where every answer holds to rounding.
  const Example* worst_example() const;
  /// Adds one grade; `show` is called where it is the first of its class and not to rounding.
  void add(const Grade& grade, const std::function<Example()>& show);
};

/// A crash, a hang, a breach of the protocol.
struct Failure {
  std::string at;                     ///< the known answer, the law and its case, the scene
  std::string reason;                 ///< what the subject did
  std::vector<std::string> commands;  ///< that show the right answer, and ask the subject again
};

/// A law that was not asked since the subject lacks an operation.
struct LawNotAsked {
  std::string number;              ///< "(2) law 1"
  std::vector<std::string> needs;  ///< what it lacks
};

/// Which classes fail, by profile.
struct Profile {
  std::string name;
  std::array<bool, kClasses> fails{};
  std::optional<int> bits;  ///< the format it demands

  bool accepts(const Row& row) const;
};

/// What is known of the numbers that came back; open where no operation tells.
struct Environment {
  int bits = 53;                       ///< that answers are judged by
  int bits_seen = 0;                   ///< the most significant bits of any number of an answer
  std::optional<bool> exact = {};      ///< all bits of a number arrive
  std::optional<bool> flushes = {};    ///< subnormal numbers become zero
  std::optional<bool> contracts = {};  ///< products are fused with sums
  double seconds = 0;                  ///< of asking for known answers, by the clock
  double cpu_seconds = 0;              ///< of them, those in which this process computed
};

struct Verdict {
  std::string subject, data;
  Profile profile;
  Environment environment;
  std::vector<Row> rows;
  std::vector<std::string> not_offered;
  std::vector<LawNotAsked> laws_not_asked;
  std::vector<Failure> failures;  ///< the first few
  std::uint64_t failed = 0;       ///< all of them
  bool interrupted = false;
  std::vector<std::string> expected_failures;  ///< names of rows that may fail, and must
  std::map<std::string, std::string> notes;    ///< in order of their keys: what is to be known besides

  void note_failure(Failure failure);

  std::uint64_t asked() const;
  std::array<std::uint64_t, kClasses> counts() const;
  bool expected_to_fail(const Row& row) const;
  /// Rows that fail and may not, and rows that may and do not.
  std::vector<const Row*> failing() const;
  std::vector<std::string> unexpected_passes() const;
  /// Whether a row of that name was asked.
  bool has_row(const std::string& pattern) const;
  /// What explains most of the wrong answers, half of them at least; several where they explain as many.
  static std::vector<std::string> best_hypotheses(const Row& row);
};

}  // namespace tps::properties::conform
