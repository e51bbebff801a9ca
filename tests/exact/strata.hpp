// Timing queries that aim at edges, by stratum; the same ones on every machine.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "verify/exact/timing_query.hpp"

namespace tps::exact::strata {

/// SplitMix64: the standard's engines are portable but its distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  double uniform(double low, double high);
  int integer(int low, int high);        ///< inclusive
  double any_double(int low, int high);  ///< random sign and significand, exponent uniform in [low, high]

 private:
  std::uint64_t state_;
};

struct Stratum {
  std::string name;
  std::vector<TimingQuery> queries;

  friend std::ostream& operator<<(std::ostream& out, const Stratum& stratum) { return out << stratum.name; }
};

/// Names the parametrised tests.
struct Name {
  template <typename TestParamInfo>
  std::string operator()(const TestParamInfo& stratum) const {
    return stratum.param.name;
  }
};

/// A at rest in the origin.
TimingQuery relative(Kind kind, Vec3 r, Vec3 v, double L);

/// The query in hexadecimal, for messages.
std::string text(const TimingQuery& query);

TimingQuery plain(Random& random, Kind kind);

/// Passes the limit at a distance L(1 ∓ 2^-k): exact integers times powers of two, from x0 away.
TimingQuery graze(Kind kind, int k, double side, double x0, int turn);

/// Every stratum, `count` queries in each.
std::vector<Stratum> all(std::uint64_t seed, int count);

/// All numbers times 2^length (positions, L) and 2^speed.
TimingQuery scaled(TimingQuery query, int length, int speed);

}  // namespace tps::exact::strata
