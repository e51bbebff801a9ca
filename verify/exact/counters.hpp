// How many questions reached which stage.
#pragma once

#include "reference/engine/timing_counters.hpp"

namespace tps::exact {

using tps::StageCounts;
/// Counters of every filter, given by reference and owned by the caller: one a thread.
using Counters = TimingCounters;

}  // namespace tps::exact
