// Broken laws as files: cases of laws, which a test replays, and known answers, which anybody can judge by.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "properties/check_law.hpp"

namespace tps::properties {

/// A case of a law that was broken once, by whom and why (data/schemas/regression.schema.json).
struct Regression {
  const Law* law;
  Case shrunk;
  std::string subject, why;
};

/// One line of a regression file, with its newline.
std::string regression_line(const Finding& finding, const std::string& subject);

/// The lines of a file. Throws InputError that names file, line, what is wrong and what is allowed.
std::vector<Regression> read_regressions(std::istream& in, const std::string& name);

/// Whether every number of a case is one of the format.
bool fits(const Case& c, const Format& format);

/// The questions of findings as a known-answer file (docs/vectors.md): certified answers with their proofs.
/// Questions without a known answer are left out; empty if none has one.
std::string known_answer_file(const std::vector<const Finding*>& findings, std::uint64_t seed);

}  // namespace tps::properties
