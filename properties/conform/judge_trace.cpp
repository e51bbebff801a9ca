#include "properties/conform/judge_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "properties/conform/expected.hpp"
#include "properties/conform/run_source.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/scratch_file.hpp"

namespace tps::properties::conform {
namespace {

bool is_defensible(const std::string& reading) {
  constexpr std::array<const char*, 5> kSilent{"D9:", "D11:", "D12:", "D13:", "D16:"};
  return std::any_of(kSilent.begin(), kSilent.end(), [&](const char* d) { return reading.starts_with(d); });
}

void add_wrong_end(check::CheckReport& report, std::string message) {
  check::Finding finding;
  finding.rule = check::Rule::end;
  finding.line = report.lines;
  finding.message = std::move(message);
  report.findings.push_back(finding);
  ++report.rules[static_cast<std::size_t>(check::Rule::end)].violated;
}

/// A run that is asked for all of a scene ends at start_time + duration; the check allows an earlier end, of
/// who was told to stop there. Rounded once or twice, in float at worst.
void judge_duration(const std::string& scene, const std::string& trace, check::CheckReport& report) {
  constexpr double kRounding = 0x1p-22;
  const Json asked = Json::parse(scene);
  const auto number = [&](const char* key, double otherwise) {
    return asked.contains(key) ? numbers_of(asked.at(key)).value().at(0) : otherwise;
  };
  const double start = number("start_time", 0), duration = number("duration", 0);
  const std::size_t last = trace.rfind('\n', trace.size() - 2);
  const Json line = Json::parse(trace.substr(last == std::string::npos ? 0 : last + 1), nullptr, false);
  const auto t = line.is_object() && line.contains("t") ? numbers_of(line.at("t")) : std::nullopt;
  if (!t) return;
  const double off = std::fabs(t->at(0) - start - duration);
  if (std::isfinite(duration) && off <= kRounding * (std::fabs(start) + duration)) return;
  add_wrong_end(report, fmt::format("the run ends by its duration at t = {}; it begins at {} and lasts {}",
                                    t->at(0), start, duration));
}

/// The check takes the reason of an end as given: somebody may have stopped the run. Here nobody has.
void judge_reason(check::CheckReport& report, std::optional<std::uint64_t> most_events) {
  constexpr std::array<const char*, 4> kByItself{"", "duration", "no_more_events",
                                                 "stalled"};  // "": judged already
  if (std::find(kByItself.begin(), kByItself.end(), report.end) != kByItself.end()) return;
  if (report.end == "max_events" && most_events && report.events >= *most_events) return;
  add_wrong_end(report, fmt::format("the run ends as {} after {} events; it was asked for {}", report.end,
                                    report.events,
                                    most_events ? fmt::format("{} events or the whole duration", *most_events)
                                                : std::string("the whole duration of the scene")));
}

}  // namespace

Class class_of(const check::Finding& finding) {
  if (finding.outcome == check::Outcome::undecided) return Class::beyond;
  if (is_defensible(finding.reading)) return Class::other_reading;
  return finding.message.starts_with("creep:") ? Class::worse : Class::wrong;
}

std::string words_of(const check::Finding& f) {
  std::string text = fmt::format("line {}, {}: {}", f.line, check::name(f.rule), f.message);
  if (f.off && f.allowed) text += fmt::format("; off by {:.3g} ulp, allowed {:.3g}", *f.off, *f.allowed);
  if (!f.reading.empty()) text += "; another reading of the paper, " + f.reading;
  return text;
}

check::CheckReport checked(const std::string& scene, const std::string& trace) {
  const ScratchFile file(trace), scene_file(scene);
  check::CheckOptions options;
  options.scene = scene_file.path();
  options.max_reports = 10 * kMostEventsOfARun;  // of each rule: all
  check::CheckReport report = check::check_trace(file.path(), options);
  if (report.end == "duration") judge_duration(scene, trace, report);
  return report;
}

check::CheckReport checked_run(const Scene& scene, const std::string& trace,
                               std::optional<std::uint64_t> most_events) {
  check::CheckReport report = checked(write_scene(scene), trace);
  judge_reason(report, most_events);
  return report;
}

const check::Finding* worst_of(const check::CheckReport& report) {
  const auto worst = std::max_element(
      report.findings.begin(), report.findings.end(),
      [](const check::Finding& one, const check::Finding& other) { return class_of(one) < class_of(other); });
  return worst == report.findings.end() ? nullptr : &*worst;
}

Beginning judged_beginning(const Scene& scene, const std::string& trace) {
  if (trace.empty()) return {false, "it wrote nothing, or did not flush it"};
  check::CheckReport report;
  try {
    report = checked(write_scene(scene), trace);
  } catch (const InputError& error) {
    return {false, "what it wrote until then is no trace: " + first_problem(error)};
  }
  // That there is no end, and no progress, follows from the rest.
  std::erase_if(report.findings, [](const check::Finding& finding) {
    return finding.rule == check::Rule::end || finding.rule == check::Rule::progress;
  });
  const check::Finding* worst = worst_of(report);
  const std::string written =
      fmt::format("the {} events that it wrote until then were judged: ", report.events);
  if (worst == nullptr) return {false, written + "nothing is wrong with them"};
  const auto alike =
      std::count_if(report.findings.begin(), report.findings.end(), [&](const check::Finding& other) {
        return other.rule == worst->rule && class_of(other) == class_of(*worst) &&
               other.particles == worst->particles;
      });
  return {class_of(*worst) == Class::wrong,
          fmt::format("{}{}, {}{}", written, name(class_of(*worst)), words_of(*worst),
                      alike > 1 ? fmt::format(", and so {} times", alike) : "")};
}

}  // namespace tps::properties::conform
