// Laws of whole runs: each a sentence, a number, a page, the scenes it is about, and a judge.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "properties/runs/implied_state.hpp"
#include "properties/runs/scenes.hpp"
#include "properties/runs/simulator.hpp"

namespace tps::properties::runs {

/// What a judge says of one scene.
struct RunVerdict {
  enum class Kind { holds, broken, not_asked };  ///< not_asked: the run is none that the law is about
  Kind kind = Kind::holds;
  std::string why;  ///< of a broken law: the event, what was found, what is allowed

  static RunVerdict broken(std::string why) { return {Kind::broken, std::move(why)}; }
  static RunVerdict not_asked() { return {Kind::not_asked, {}}; }
  static RunVerdict of(const std::optional<std::string>& fault) {
    return fault ? broken(*fault) : RunVerdict{};
  }
};

struct RunLaw {
  int number;
  std::string name;                                          ///< of its test
  std::string sentence;                                      ///< what holds
  std::string page;                                          ///< where it is derived or decided
  std::function<rc::Gen<SmallScene>(int dimension)> scenes;  ///< dimension 0: 2 or 3
  std::function<RunVerdict(const Scene&, Simulator&)> judge;
  bool needs_exact_timing = false;  ///< not asked of runs timed by the paper's literal formulas (docs/eq2.md)
  bool compares_runs = false;       ///< asked in any scalar; others judge numbers that Real must hold
};

/// All laws of runs, ascending by number.
const std::vector<RunLaw>& run_laws();

/// What judges the traces that a law cannot: `tps check`, which whoever asks laws passes in, so that nothing
/// here is compiled with the engine.
struct Instead {
  std::function<std::optional<std::string>(const std::string& trace)>
      fault_in;              ///< of a whole trace, in words
  std::uint64_t traces = 0;  ///< judged so far
};

/// A RapidCheck property: generates a scene, has it judged, fails with the law, its page and the finding. A
/// minimal trace is judged by `instead`; without that it fails, too.
void check_law(const RunLaw& law, Simulator& simulator, int dimension = 0, Instead* instead = nullptr);

/// The scenes of most laws.
inline std::function<rc::Gen<SmallScene>(int)> of(Wanted wanted) {
  return [wanted](int dimension) mutable {
    wanted.dimension = dimension;
    return small_scene(wanted);
  };
}

/// What is wrong at an event, given the state before it; nothing where all is well.
using EventJudge =
    std::function<std::optional<std::string>(const ImpliedState& before, const TracedEvent& event)>;

/// Runs a scene and asks about every event; the first fault, with the event it was found at.
std::optional<std::string> first_fault(const Scene& scene, Simulator& simulator, const EventJudge& judge);

/// "found x, allowed y" for a quantity that must not exceed a bound; nothing where it does not.
std::optional<std::string> beyond(const std::string& what, Real found, Real allowed);

/// Laws by subject; run_laws() has them all.
std::vector<RunLaw> response_laws();
std::vector<RunLaw> flight_laws();
std::vector<RunLaw> tether_laws();
std::vector<RunLaw> group_laws();
std::vector<RunLaw> symmetry_laws();
std::vector<RunLaw> continuation_laws();
std::vector<RunLaw> orbit_laws();
std::vector<RunLaw> contact_laws();
std::vector<RunLaw> effect_laws();
std::vector<RunLaw> box_outside_laws();
std::vector<RunLaw> wall_laws();
std::vector<RunLaw> box_laws();

}  // namespace tps::properties::runs
