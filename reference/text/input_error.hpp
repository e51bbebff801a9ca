// What is wrong with a file that we were given, all of it at once.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tps {

/// One thing that is wrong, and where: `line` counts from 1 (0: the file as a whole), `pointer` is a JSON
/// pointer (RFC 6901; empty: the document as a whole).
struct InputProblem {
  std::string file;
  std::size_t line = 0;
  std::string pointer;
  std::string message;
};

/// "FILE:LINE: POINTER: MESSAGE", without the parts that do not apply.
std::string format_problem(const InputProblem& problem);

/// Bad input: the one exception that readers of files throw. what() has a line for each problem, in the
/// order of the file; after `max_shown` of them it says how many more there are.
class InputError : public std::runtime_error {
 public:
  static constexpr std::size_t max_shown = 100;

  /// REQUIRES at least one problem. `all`: whether these are all that there are.
  explicit InputError(std::vector<InputProblem> problems, bool all = true);

  /// Sorted by line; problems of one line in the order in which they were found.
  const std::vector<InputProblem>& problems() const { return problems_; }

 private:
  std::vector<InputProblem> problems_;
};

/// Collects the problems of one file, `max_kept` at most: whoever looks for problems stops where it is full,
/// so that a file with a million errors costs neither memory nor patience.
class InputProblems {
 public:
  static constexpr std::size_t max_kept = 1000;

  explicit InputProblems(std::string file) : file_(std::move(file)) {}

  /// Does nothing where it is full.
  void add(std::size_t line, std::string pointer, std::string message);
  void add(const InputProblem& problem);

  bool empty() const { return problems_.empty(); }
  bool full() const { return problems_.size() >= max_kept; }
  const std::string& file() const { return file_; }
  const std::vector<InputProblem>& problems() const { return problems_; }

  /// Whether some problem lies at `pointer` or inside it.
  bool touches(const std::string& pointer) const;

  /// Throws InputError if anything was added.
  void throw_if_any() const;

 private:
  std::string file_;
  std::vector<InputProblem> problems_;
};

}  // namespace tps
