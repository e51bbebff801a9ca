#include "tests/trace_check/matrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace tps::mutation {
namespace {

std::string_view sign(Cell cell) {
  switch (cell) {
    case Cell::not_applicable:
      return "–";
    case Cell::killed:
      return "killed";
    case Cell::survived:
      return "**survived**";
    case Cell::legal:
      return "legal";
  }
  return "";
}

void add_once(std::vector<std::string>& list, const std::string& item) {
  if (std::ranges::find(list, item) == list.end()) list.push_back(item);
}

class PrintsTheMatrix : public ::testing::Environment {
 public:
  void TearDown() override { std::cout << matrix().table(); }
};

[[maybe_unused]] const auto* const printer = ::testing::AddGlobalTestEnvironment(new PrintsTheMatrix);

}  // namespace

void Matrix::note(std::string_view mutation, const std::string& run, Cell cell) {
  add_once(mutations_, std::string(mutation));
  add_once(runs_, run);
  cells_[{std::string(mutation), run}] = cell;
}

std::string Matrix::table() const {
  if (runs_.empty()) return "";
  std::string head = "| mutation |";
  std::string line = "|---|";
  for (const std::string& run : runs_) {
    head += ' ' + run + " |";
    line += "---|";
  }
  std::string text = head + '\n' + line + '\n';
  for (const std::string& mutation : mutations_) {
    text += "| " + mutation + " |";
    for (const std::string& run : runs_) {
      const auto cell = cells_.find({mutation, run});
      text += ' ' + std::string(cell == cells_.end() ? "" : sign(cell->second)) + " |";
    }
    text += '\n';
  }
  return text;
}

Matrix& matrix() {
  static Matrix of_program;
  return of_program;
}

}  // namespace tps::mutation
