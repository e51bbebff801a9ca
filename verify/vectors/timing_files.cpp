// The strata of block_time and tether_time.
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verify/exact/exact_verdict.hpp"
#include "verify/vectors/one_bit.hpp"
#include "verify/vectors/stratum.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::vectors {
namespace {

using exact::Kind;
using exact::TimingQuery;

exact::Verdict verdict_of_query(const TimingQuery& query) {
  exact::Counters counters;
  return exact::exact_verdict(query, counters);
}

double& any_component(Random& random, TimingQuery& query) {
  const int which = random.integer(0, 3);
  return which == 3 ? query.L : query.u_B[static_cast<std::size_t>(which)];
}

/// Two queries on the two sides of a change of verdict, one bit apart.
std::pair<TimingQuery, TimingQuery> verdict_twins(Random& random, Kind kind) {
  const std::vector<exact::strata::TimingStratum>& families = exact::strata::timing_strata();
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const auto family = static_cast<std::size_t>(random.integer(0, 5));  // plain, graze, …, tangent
    TimingQuery query = families[family].query(random, kind, 3);
    double& x = any_component(random, query);
    const double first = x;
    const double side = random.coin() ? 1 : -1;
    const double step = side * std::ldexp(1.0, -random.integer(1, 40));
    const double last = x * (1 + step);
    if (first == 0 || first == last) continue;
    if (const auto found = twins(query, x, first, last, verdict_of_query)) return *found;
  }
  throw std::logic_error("no change of verdict found; the families of timing_strata() have changed");
}

bool is_planar(const TimingQuery& query) {
  return query.u_A[2] == 0 && query.u_B[2] == 0 && query.v_A[2] == 0 && query.v_B[2] == 0;
}

/// Even cases of the plane in 2 components, odd ones with z = 0 written out.
int written_dimension(const TimingQuery& query, std::uint64_t number) {
  return is_planar(query) && number % 2 == 0 ? 2 : 3;
}

std::vector<std::string> tags_of(const TimingQuery& query, std::string_view stratum) {
  std::vector<std::string> tags{std::string(stratum)};
  if (is_planar(query)) tags.emplace_back("planar");
  return tags;
}

/// Two particles at one point, as one at the centre of its container is: no axis, and for tethers a way of L
/// to go in whatever direction.
TimingQuery coincident(Random& random, Kind kind, int dimension) {
  TimingQuery query = exact::strata::plain(random, kind, dimension);
  query.u_B = query.u_A;
  if (random.integer(0, 7) == 0) query.v_B = query.v_A;
  if (random.coin()) return query;
  const int speed = random.integer(-300, 300), length = random.integer(-300, 300);
  return exact::strata::scaled(query, length, speed);
}

/// Far inside the limit, at 2^-k of a distance, or head-on, in units in which times are long or short.
TimingQuery units(Random& random, Kind kind, int dimension) {
  TimingQuery query = exact::strata::plain(random, kind, dimension);
  const bool head_on = random.coin();
  const int k = random.integer(0, 45);
  for (std::size_t n = 0; n < query.u_A.size(); ++n) {
    const double r = query.u_B[n] - query.u_A[n];
    if (head_on) query.v_B[n] = query.v_A[n] - r / 4;
    query.u_B[n] = query.u_A[n] + std::ldexp(r, head_on ? 2 : -k);
  }
  const int length = random.integer(-90, 90), speed = random.integer(-90, 90);
  return exact::strata::scaled(query, length, speed);
}

}  // namespace

void add_timing_strata(std::vector<Stratum>& strata) {
  for (const Kind kind : {Kind::block, Kind::tether}) {
    const Op op = operations::timing_of(kind);
    for (const exact::strata::TimingStratum& family : exact::strata::timing_strata()) {
      const int in_space = family.name == "graze" ? 300 : family.name == "graded_limit" ? 60 : 125;
      strata.push_back(
          {op, std::string(family.name), std::string(family.why), in_space + kInThePlane,
           [kind, family, in_space](Random& random, std::uint64_t number) -> Problem {
             const TimingQuery query = family.query(random, kind, dimension_of_case(number, in_space));
             return {timing_input(query, written_dimension(query, number)), tags_of(query, family.name)};
           },
           family.name == "planar" ? 2 : 1});
    }
    strata.push_back({op, "twins", "one bit apart on the two sides of a change of verdict", 200,
                      [kind](Random& random, std::uint64_t number) -> Problem {
                        const auto [one, other] = verdict_twins(random, kind);
                        const TimingQuery& query = number % 2 == 0 ? one : other;
                        return {timing_input(query, 3), tags_of(query, "twin")};
                      },
                      2});
    const auto add = [&](const char* name, const char* why, int in_space,
                         TimingQuery (*query_of)(Random&, Kind, int)) {
      strata.push_back({op, name, why, in_space + kInThePlane,
                        [kind, name, in_space, query_of](Random& random, std::uint64_t number) -> Problem {
                          const int dimension = dimension_of_case(number, in_space);
                          return {timing_input(query_of(random, kind, dimension), dimension), {name}};
                        }});
    };
    add("units", "head-on, or 2^-k as far apart, in units of length and speed of 2^-90 to 2^90", 12, units);
    add("coincident", "both particles at one point", 30, coincident);
  }
}

}  // namespace tps::vectors
