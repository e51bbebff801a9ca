#include "properties/campaign/trial.hpp"

#include <algorithm>
#include <exception>

#include "properties/runs/simulator.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/scratch_file.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::properties::campaign {
namespace {

std::string first_alarm(const check::CheckReport& report) {
  const auto is_alarm = [&](const check::Finding& f) {
    return f.outcome == check::Outcome::violated || report.timing == "certified";
  };
  const auto found = std::find_if(report.findings.begin(), report.findings.end(), is_alarm);
  if (found == report.findings.end()) return "a rule is violated without a finding";
  return std::string(found->outcome == check::Outcome::violated ? "" : "undecided: ") +
         std::string(check::name(found->rule)) + ", line " + std::to_string(found->line) + ": " +
         found->message;
}

Trial judged(const std::string& text) {
  Trial trial;
  if (text.find("nan") != std::string::npos) return {Fate::alarm, 0, 0, false, "the trace holds a NaN"};
  const ScratchFile trace(text);
  const check::CheckReport report = check::check_trace(trace.path());
  trial.events = report.events;
  trial.undecided = report.undecided();
  trial.inconclusive = report.inconclusive();
  const bool open = trial.undecided > 0 && report.timing == "certified";
  if (!report.conforming() || open) {
    trial.fate = Fate::alarm;
    trial.message = first_alarm(report);
  } else if (trial.undecided > 0) {
    trial.fate = Fate::undecided;
  } else if (report.end == "out_of_range") {
    trial.fate = Fate::left_range;
  }
  return trial;
}

}  // namespace

const std::vector<Mode>& all_modes() {
  static const std::vector<Mode> modes = {
      {"double", "certified"}, {"double", "stable"}, {"double", "paper"},       {"float", "certified"},
      {"float", "stable"},     {"float", "paper"},   {"long-double", "stable"}, {"long-double", "paper"},
      {"mp50", "stable", 20},  {"mp50", "paper", 40}};
  return modes;
}

Trial try_scene(const NastyScene& nasty, const Mode& mode, std::uint64_t max_events) {
  try {
    const auto simulator = runs::reference_simulator(mode.scalar, mode.timing);
    const auto traced = [&](const char* detector) {
      return simulator->simulate(nasty.scene, {max_events, kStateEvery, detector});
    };
    const std::string trace = traced("all-pairs");
    if (traced("cells") != trace) return {Fate::alarm, 0, 0, false, "cells and all pairs differ"};
    return judged(trace);
  } catch (const InputError& refused) {
    return {Fate::left_range, 0, 0, false, refused.what()};
  } catch (const std::exception& error) {
    return {Fate::alarm, 0, 0, false, std::string("the run throws: ") + error.what()};
  }
}

}  // namespace tps::properties::campaign
