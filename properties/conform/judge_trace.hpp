// What the trace check says of a run, in the classes of a verdict.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "properties/conform/answer_class.hpp"
#include "reference/scene/scene.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::properties::conform {

/// OTHER READING where the paper is silent and the check names the decision (docs/decisions.md, N104).
Class class_of(const check::Finding& finding);
std::string words_of(const check::Finding& finding);

/// Every finding on a trace, full or minimal. `scene` is the text of a scene file. Throws InputError where it
/// is no trace.
check::CheckReport checked(const std::string& scene, const std::string& trace);

/// The same of a run that was asked for all of a scene, or for so many events: it may not end before.
check::CheckReport checked_run(const Scene& scene, const std::string& trace,
                               std::optional<std::uint64_t> most_events);

/// The worst of a report, null where nothing was found.
const check::Finding* worst_of(const check::CheckReport& report);

/// What a run wrote that did not come to its end.
struct Beginning {
  bool is_wrong = false;  ///< a step is; that the end is missing does not count
  std::string words;      ///< its worst step, or that there is none
};
Beginning judged_beginning(const Scene& scene, const std::string& trace);

}  // namespace tps::properties::conform
