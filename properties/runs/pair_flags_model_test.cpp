// Random sequences of operations on Tethers and Responded, against sets of pairs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include <set>
#include <tuple>

#include "reference/engine/tethers.hpp"

namespace tps::properties::runs {
namespace {

constexpr int kFlagged = 5;

using Pairs = std::set<std::pair<int, int>>;
using OnTethers = rc::state::Command<Pairs, Tethers>;

struct TwoParticles {
  int i = *rc::gen::inRange(0, kFlagged), j = *rc::gen::inRange(0, kFlagged);
  std::pair<int, int> ordered() const { return std::minmax(i, j); }
};

void same_tethers(const Pairs& model, const Tethers& tethers) {
  for (int i = 0; i < kFlagged; ++i) {
    std::vector<int> partners;
    for (int j = 0; j < kFlagged; ++j) {
      const bool tied = model.contains(std::minmax(i, j));
      RC_ASSERT(tethers.contains(i, j) == tied);
      if (tied) partners.push_back(j);
    }
    RC_ASSERT(tethers.of(i) == partners);
    RC_ASSERT(tethers.count(i) == partners.size());
  }
}

struct Tie : OnTethers, TwoParticles {
  void checkPreconditions(const Pairs& model) const override { RC_PRE(i != j && !model.contains(ordered())); }
  void apply(Pairs& model) const override { model.insert(ordered()); }
  void run(const Pairs& model, Tethers& tethers) const override {
    tethers.add(i, j);
    same_tethers(nextState(model), tethers);
  }
  void show(std::ostream& out) const override { out << "tie " << i << " " << j; }
};

struct Untie : OnTethers, TwoParticles {
  void checkPreconditions(const Pairs& model) const override { RC_PRE(model.contains(ordered())); }
  void apply(Pairs& model) const override { model.erase(ordered()); }
  void run(const Pairs& model, Tethers& tethers) const override {
    tethers.remove(i, j);
    same_tethers(nextState(model), tethers);
  }
  void show(std::ostream& out) const override { out << "untie " << i << " " << j; }
};

RC_GTEST_PROP(TethersModel, IsASetOfPairs, ()) {
  Tethers tethers(kFlagged);
  rc::state::check(Pairs{}, tethers, rc::state::gen::execOneOfWithArgs<Tie, Untie>());
}

/// The last particle's mass is infinite: its velocity never changes.
constexpr int kFixed = kFlagged - 1;

using Flags = std::set<std::tuple<int, int, Limit>>;
using OnResponded = rc::state::Command<Flags, Responded>;

void same_flags(const Flags& model, const Responded& responded) {
  for (int i = 0; i < kFlagged; ++i) {
    for (int j = 0; j < kFlagged; ++j) {
      for (const Limit limit : {Limit::inner, Limit::outer}) {
        if (i == j) continue;
        RC_ASSERT(responded.contains(i, j, limit) == model.contains({std::min(i, j), std::max(i, j), limit}));
      }
    }
  }
}

struct Respond : OnResponded, TwoParticles {
  Limit limit = *rc::gen::element(Limit::inner, Limit::outer);

  void checkPreconditions(const Flags&) const override { RC_PRE(i != j); }
  void apply(Flags& model) const override { model.insert({std::min(i, j), std::max(i, j), limit}); }
  void run(const Flags& model, Responded& responded) const override {
    responded.add(i, j, limit);
    same_flags(nextState(model), responded);
  }
  void show(std::ostream& out) const override {
    out << i << " and " << j << " respond at the " << (limit == Limit::inner ? "inner" : "outer") << " limit";
  }
};

struct ChangeVelocity : OnResponded {
  int i = *rc::gen::inRange(0, kFixed);

  void apply(Flags& model) const override {
    std::erase_if(model, [this](const auto& f) { return std::get<0>(f) == i || std::get<1>(f) == i; });
  }
  void run(const Flags& model, Responded& responded) const override {
    responded.forget(i);
    RC_ASSERT(responded.of(i).empty());
    same_flags(nextState(model), responded);
  }
  void show(std::ostream& out) const override { out << "the velocity of " << i << " changes"; }
};

RC_GTEST_PROP(RespondedModel, IsASetOfFlags, ()) {
  std::vector<bool> fixed(kFlagged, false);
  fixed[kFixed] = true;
  Responded responded(fixed);
  rc::state::check(Flags{}, responded, rc::state::gen::execOneOfWithArgs<Respond, Respond, ChangeVelocity>());
}

}  // namespace
}  // namespace tps::properties::runs
