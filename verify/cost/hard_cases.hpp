// Scenes that are hard in one known way each, and which scalar and timing is good enough for them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps::cost {

/// What makes an answer right.
enum class RightBy {
  events,  ///< it has every event of the truth, and its end
  end,     ///< it ends like the truth, after however many events
  nothing  ///< real arithmetic has ties, which the truth decides by rounding, too: to agree is luck
};

struct HardCase {
  std::string name, what;
  std::function<Scene()> scene;
  std::uint64_t events;  ///< at most, of a run
  RightBy right_by = RightBy::events;
  bool is_long = false;  ///< takes a quarter of a minute: left out of a quick study
};

/// Seeds are fixed: the table is the same everywhere.
std::vector<HardCase> hard_cases();

/// What became of a case in one arithmetic.
struct CaseOutcome {
  std::string scalar, timing;
  std::string end;  ///< as in RunSummary; "refused" where the scalar cannot hold the scene
  std::uint64_t events = 0;
  /// Events, in order, that are those of the run in mp100; absent where all are and the run ends alike; or
  /// where it ends alike, if that is what counts.
  std::optional<std::uint64_t> horizon;
  double worst_excess = 0;  ///< beyond a limit, at an event or at the end, in ulps
};

struct CaseResult {
  std::string name, what;
  std::uint64_t events = 0;  ///< of the run in mp100
  std::string end;           ///< of that run
  RightBy right_by = RightBy::events;
  std::vector<CaseOutcome> outcomes;
  /// The fewest of proof_digits() in which affine arithmetic proves every event of the stored scene and its
  /// end (enclosed_run.hpp), by bisection; absent where none does, or the scene is not of that kind.
  std::optional<long> proven_bits;
  std::string unproven;  ///< where it is absent, why

  /// The first, in the order of cost, that is right; null where there is none.
  const CaseOutcome* good_enough() const;
};

/// 24, 53, 64, 113, 200, 400.
const std::vector<long>& proof_digits();

/// A case in float, double (as printed, stable, certified), long double, quad and mp50, against mp100.
CaseResult measure_case(const HardCase& one);

}  // namespace tps::cost
