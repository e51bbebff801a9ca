// The lines of a trace, which copies of it share until one of them changes a line: whoever breaks a trace of
// a thousand lines breaks a few of them.
#pragma once

#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace tps::mutation {

using Json = nlohmann::ordered_json;

class SharedLines {
 public:
  SharedLines() = default;
  SharedLines(std::initializer_list<Json> lines) {
    for (const Json& line : lines) push_back(line);
  }

  std::size_t size() const { return lines_.size(); }
  const Json& operator[](std::size_t n) const { return lines_[n]->json; }
  const Json& front() const { return lines_.front()->json; }
  const Json& back() const { return lines_.back()->json; }

  /// A line to change. REQUIRES that nobody writes to it once these lines have been copied or asked for their
  /// text.
  Json& change(std::size_t n);
  Json& change_last() { return change(size() - 1); }

  void push_back(Json line) { lines_.push_back(std::make_shared<Line>(Line{std::move(line), ""})); }
  void pop_back() { lines_.pop_back(); }
  void insert(std::size_t before, Json line);
  void erase(std::size_t n);
  void keep_first(std::size_t count) { lines_.resize(count); }
  void swap(std::size_t a, std::size_t b) { std::swap(lines_[a], lines_[b]); }

  /// All lines as bytes, each with its end.
  std::string text() const;

 private:
  struct Line {
    Json json;
    std::string text;  ///< empty until asked for
  };
  std::vector<std::shared_ptr<Line>> lines_;
};

}  // namespace tps::mutation
