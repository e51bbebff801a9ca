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

std::vector<TimingVerdict> verdicts_of(TimingKind kind) {
  using enum TimingVerdict;
  switch (kind) {
    case TimingKind::block:
      return {static_pair, receding, overlap, contact, miss, tangent, hit};
    case TimingKind::tether:
      return {static_pair, hit, taut, overstretched, turning};
    case TimingKind::plane:
      break;
  }
  return {static_pair, receding, overlap, contact, hit};
}

std::vector<std::string> verdict_hazards() {
  std::vector<std::string> all;
  for (const TimingKind kind : {TimingKind::block, TimingKind::tether}) {
    for (const TimingVerdict verdict : verdicts_of(kind)) all.push_back(verdict_name(kind, verdict));
  }
  return all;
}

}  // namespace tps::properties
