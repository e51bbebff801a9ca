#include "reference/text/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reference/text/printable.hpp"

namespace tps {
namespace {

// A message is ours but for what it quotes, which its writer keeps short; these bounds are for what slips
// through, and for pointers, which are made of keys.
constexpr std::size_t most_of_file = 1000;
constexpr std::size_t most_of_pointer = 300;
constexpr std::size_t most_of_message = 2000;

InputProblem fit_to_print(const InputProblem& problem) {
  return {printable(problem.file, most_of_file), problem.line, printable(problem.pointer, most_of_pointer),
          printable(problem.message, most_of_message)};
}

std::vector<InputProblem> all_printable(std::vector<InputProblem> problems) {
  for (InputProblem& problem : problems) problem = fit_to_print(problem);
  return problems;
}

std::vector<InputProblem> sorted_by_line(std::vector<InputProblem> problems) {
  std::stable_sort(problems.begin(), problems.end(),
                   [](const InputProblem& a, const InputProblem& b) { return a.line < b.line; });
  return problems;
}

// REQUIRES sorted problems.
std::string format_all(const std::vector<InputProblem>& problems, bool all) {
  std::string text;
  const std::size_t shown = std::min(problems.size(), InputError::max_shown);
  for (std::size_t k = 0; k < shown; ++k) {
    if (k > 0) text += '\n';
    text += format_problem(problems[k]);
  }
  const std::size_t more = problems.size() - shown;
  if (more > 0) text += fmt::format("\n… and {}{} more", all ? "" : "at least ", more);
  return text;
}

}  // namespace

std::string format_problem(const InputProblem& problem) {
  std::string text = problem.file;
  if (problem.line > 0) text += fmt::format(":{}", problem.line);
  if (!text.empty()) text += ": ";
  if (!problem.pointer.empty()) text += problem.pointer + ": ";
  return text + problem.message;
}

InputError::InputError(std::vector<InputProblem> problems, bool all)
    : std::runtime_error(format_all(sorted_by_line(all_printable(problems)), all)),
      problems_(sorted_by_line(all_printable(std::move(problems)))) {}

void InputProblems::add(std::size_t line, std::string pointer, std::string message) {
  if (full()) return;
  // The pointer as it is: touches() compares it. InputError makes it fit to print.
  problems_.push_back({file_, line, std::move(pointer), printable(message, most_of_message)});
}

void InputProblems::add(const InputProblem& problem) {
  add(problem.line, problem.pointer, problem.message);
}

bool InputProblems::touches(const std::string& pointer) const {
  return std::any_of(problems_.begin(), problems_.end(), [&](const InputProblem& problem) {
    return problem.pointer.starts_with(pointer) &&
           (problem.pointer.size() == pointer.size() || problem.pointer[pointer.size()] == '/');
  });
}

void InputProblems::throw_if_any() const {
  if (!empty()) throw InputError(problems_, !full());
}

}  // namespace tps
