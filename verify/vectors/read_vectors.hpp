// Known-answer files, read line by line.
#pragma once

#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "verify/vectors/known_answer.hpp"

namespace tps::vectors {

/// Where something was found.
struct Place {
  std::string file;
  std::size_t line;
};

/// What a reader does with a case of operation `op`, and with a line that is none.
struct VectorsVisitor {
  std::function<void(const std::string& op, const Json& known_case, const Place&)> known_case;
  std::function<void(const std::string& problem, const Place&)> problem;
};

/// Reads one or several files that follow each other in a stream. A line that is not JSON, has no header
/// before it, or lacks what a case needs is a problem; so is a count that differs from the header's (a
/// truncated file). No line may be longer than 1 MiB.
void read_vectors(std::istream& in, const std::string& name, const VectorsVisitor& visitor);

}  // namespace tps::vectors
