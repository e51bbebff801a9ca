// From a line of text to a line of a trace.
#pragma once

#include <memory>
#include <string_view>
#include <unordered_map>

#include "reference/scene/scene.hpp"
#include "verify/trace_check/line.hpp"

namespace tps::check {

/// Reads lines behind the header. Minimal traces may leave out what docs/check.md lists, and may use JSON
/// numbers.
template <typename Number>
class LineReading {
 public:
  /// `digits`: bits of the trace's scalar, which no number of it may exceed.
  LineReading(const Scene& scene, bool minimal, int digits);
  ~LineReading();

  /// Holds until the next one is read. Throws LineProblem.
  Line<Number>& read(std::string_view text);

 private:
  class Json;
  std::unique_ptr<Json> json_;
};

}  // namespace tps::check
