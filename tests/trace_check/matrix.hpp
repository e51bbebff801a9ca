// Which mutation was caught in which run, collected over the tests of a program and printed at its end.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tps::mutation {

enum class Cell { not_applicable, killed, survived, legal };

class Matrix {
 public:
  void note(std::string_view mutation, const std::string& run, Cell cell);
  /// A table in Markdown: a row for each mutation, a column for each run.
  std::string table() const;

 private:
  std::vector<std::string> mutations_, runs_;
  std::map<std::pair<std::string, std::string>, Cell> cells_;
};

/// That of this program.
Matrix& matrix();

}  // namespace tps::mutation
