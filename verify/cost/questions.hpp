// The questions of the study: the strata of the known answers, blocking and tethering in turn.
#pragma once

#include <string>
#include <vector>

#include "verify/exact/timing_query.hpp"

namespace tps::cost {

struct Hazard {
  std::string name, what;
};

/// Name and purpose of each stratum of block_time and tether_time (docs/vectors.md).
const std::vector<Hazard>& hazards();

/// `count` queries of a stratum; the same ones for a seed on every machine. REQUIRES one of hazards().
std::vector<exact::TimingQuery> questions(const std::string& stratum, std::uint64_t seed, int count);

/// The query with every number rounded to single precision, so that each arithmetic is asked the same. Not
/// valid() where a number leaves its range.
exact::TimingQuery in_single_precision(exact::TimingQuery query);

}  // namespace tps::cost
