// Timing queries that aim at edges, by stratum; the same ones on every machine.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "verify/exact/timing_query.hpp"
#include "verify/vectors/random.hpp"

namespace tps::exact::strata {

using vectors::Random;

/// What one family of queries aims at.
struct TimingStratum {
  std::string_view name;
  std::string_view why;
  TimingQuery (*query)(Random&, Kind, int dimension);  ///< of 2 dimensions: z = 0
};

/// Every family. Appending one changes no case of the others.
const std::vector<TimingStratum>& timing_strata();

TimingQuery plain(Random& random, Kind kind, int dimension = 3);

/// Passes the limit at a distance L(1 ∓ 2^-k): exact integers times powers of two, from x0 away.
TimingQuery graze(Kind kind, int k, double side, double x0, int turn);

/// A at rest in the origin.
TimingQuery relative(Kind kind, Vec3 r, Vec3 v, double L);

/// All numbers times 2^length (positions, L) and 2^speed.
TimingQuery scaled(TimingQuery query, int length, int speed);

Kind any_kind(Random& random);

/// The query in hexadecimal, for messages.
std::string text(const TimingQuery& query);

/// Queries of one stratum, of both kinds, for tests.
struct Stratum {
  std::string name;
  std::vector<TimingQuery> queries;

  friend std::ostream& operator<<(std::ostream& out, const Stratum& stratum) { return out << stratum.name; }
};

/// Every stratum, `count` queries in each.
std::vector<Stratum> all(std::uint64_t seed, int count);

/// Names parametrised tests.
struct Name {
  template <typename TestParamInfo>
  std::string operator()(const TestParamInfo& stratum) const {
    return stratum.param.name;
  }
};

}  // namespace tps::exact::strata
