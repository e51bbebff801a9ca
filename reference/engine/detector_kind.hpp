// Which detector a run uses. Apart from detector.hpp, so that asking for one needs no engine.
#pragma once

namespace tps {

enum class DetectorKind {
  automatic,  ///< all pairs for few particles, cells for many
  all_pairs,  ///< every pair (all_pairs.hpp)
  cells,      ///< neighbours only (cells/cells.hpp)
};

}  // namespace tps
