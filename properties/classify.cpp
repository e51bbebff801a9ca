#include "properties/classify.hpp"

#include "verify/exact/exact_verdict.hpp"

namespace tps::properties {
namespace {

std::string verdict_name(TimingKind kind, exact::Verdict verdict) {
  return (kind == TimingKind::block ? "block " : "tether ") + std::string(name(verdict));
}

}  // namespace

std::vector<std::string> hazards_of(const Case& c) {
  std::vector<std::string> found{c.hazard};
  if (!c.numbers.contains("L") || !c.numbers.contains("u_A")) return found;
  const PairState p = c.pair();
  exact::Counters uncounted;
  for (const TimingKind kind : {TimingKind::block, TimingKind::tether}) {
    const exact::TimingQuery query{kind, p.u_A, p.u_B, p.v_A, p.v_B, c.number("L")};
    found.push_back(verdict_name(kind, exact::exact_verdict(query, uncounted)));
  }
  return found;
}

std::vector<std::string> verdict_hazards() {
  using exact::Verdict;
  std::vector<std::string> all;
  for (const Verdict verdict : {Verdict::static_pair, Verdict::receding, Verdict::overlap, Verdict::contact,
                                Verdict::miss, Verdict::tangent, Verdict::hit})
    all.push_back(verdict_name(TimingKind::block, verdict));
  for (const Verdict verdict :
       {Verdict::static_pair, Verdict::hit, Verdict::taut, Verdict::overstretched, Verdict::turning})
    all.push_back(verdict_name(TimingKind::tether, verdict));
  return all;
}

}  // namespace tps::properties
