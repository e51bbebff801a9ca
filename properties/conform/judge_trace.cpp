#include "properties/conform/judge_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "properties/conform/run_source.hpp"
#include "properties/runs/scratch_file.hpp"

namespace tps::properties::conform {
namespace {

bool is_defensible(const std::string& reading) {
  constexpr std::array<const char*, 5> kSilent{"D9:", "D11:", "D12:", "D13:", "D16:"};
  return std::any_of(kSilent.begin(), kSilent.end(), [&](const char* d) { return reading.starts_with(d); });
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
  const runs::ScratchFile file(trace), scene_file(scene);
  check::CheckOptions options;
  options.scene = scene_file.path();
  options.max_reports = 10 * kMostEventsOfARun;  // of each rule: all
  return check::check_trace(file.path(), options);
}

const check::Finding* worst_of(const check::CheckReport& report) {
  const auto worst = std::max_element(
      report.findings.begin(), report.findings.end(),
      [](const check::Finding& one, const check::Finding& other) { return class_of(one) < class_of(other); });
  return worst == report.findings.end() ? nullptr : &*worst;
}

}  // namespace tps::properties::conform
