#include "properties/runs/laws.hpp"

#include <algorithm>
#include <sstream>

#include "reference/text/input_error.hpp"

namespace tps::properties::runs {

const std::vector<RunLaw>& run_laws() {
  static const std::vector<RunLaw> laws = [] {
    std::vector<RunLaw> all;
    for (const auto& subject :
         {response_laws, flight_laws, tether_laws, group_laws, symmetry_laws, continuation_laws, orbit_laws,
          contact_laws, effect_laws, wall_laws, box_laws, box_outside_laws}) {
      const std::vector<RunLaw> more = subject();
      all.insert(all.end(), more.begin(), more.end());
    }
    std::sort(all.begin(), all.end(), [](const RunLaw& a, const RunLaw& b) { return a.number < b.number; });
    return all;
  }();
  return laws;
}

namespace {

RunVerdict judged(const RunLaw& law, const Scene& scene, Simulator& simulator, Instead* instead) {
  try {
    return law.judge(scene, simulator);
  } catch (const MinimalTrace& minimal) {
    if (instead == nullptr) return RunVerdict::broken(minimal.what());
    ++instead->traces;
    const std::optional<std::string> fault = instead->fault_in(minimal.bytes);
    return fault ? RunVerdict::broken("a minimal trace, which the check judges instead of the law: " + *fault)
                 : RunVerdict{};
  } catch (const InputError&) {
    // A scene that the scalar does not hold is refused before it starts (N60): nothing is asked of it.
    return RunVerdict::not_asked();
  }
}

}  // namespace

void check_law(const RunLaw& law, Simulator& simulator, int dimension, Instead* instead) {
  const SmallScene small = *law.scenes(dimension);
  const RunVerdict verdict = judged(law, small.scene, simulator, instead);
  RC_PRE(verdict.kind != RunVerdict::Kind::not_asked);
  if (verdict.kind == RunVerdict::Kind::holds) return;
  std::ostringstream report;
  report << "law " << law.number << " of runs (" << law.page << "): " << law.sentence << "\n"
         << simulator.name() << ", " << simulator.scalar() << ", " << simulator.timing() << ": "
         << verdict.why;
  RC_FAIL(report.str());
}

std::optional<std::string> first_fault(const Scene& scene, Simulator& simulator, const EventJudge& judge) {
  const RunTrace trace = simulator.run(scene);
  ImpliedState implied(scene, simulator.scalar());
  for (const TracedEvent& event : trace.events) {
    const std::optional<std::string> fault = judge(implied, event);
    if (fault) {
      std::string place = "event " + std::to_string(event.k) + " (" + event.kind;
      if (event.i) place += " " + std::to_string(*event.i);
      if (event.j) place += "-" + std::to_string(*event.j);
      return place + "): " + *fault;
    }
    implied.apply(event);
  }
  return std::nullopt;
}

std::optional<std::string> beyond(const std::string& what, Real found, Real allowed) {
  if (found <= allowed) return std::nullopt;
  std::ostringstream text;
  text.precision(6);
  text << what << ": found " << found << ", allowed " << allowed;
  return text.str();
}

}  // namespace tps::properties::runs
