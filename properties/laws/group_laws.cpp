// Eqs. (6) and (7) nested: `group` (docs/protocol.md; the equations: docs/eq6.md, docs/eq7.md).
#include <algorithm>
#include <string>

#include "properties/generators/cases.hpp"
#include "properties/generators/groups.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"
#include "properties/laws/nested_loads.hpp"

namespace tps::properties::group {
namespace {

GroupCase read_group(const Case& c) {
  GroupCase group{c.numbers.at("m"), {}, {}, {}};
  const auto D = static_cast<std::size_t>(c.dimension);
  const auto vector = [&](const std::string& key, std::size_t n) {
    const std::vector<double>& x = c.numbers.at(key);
    return Vec3{x.at(n * D), x.at(n * D + 1), D > 2 ? x.at(n * D + 2) : 0};
  };
  for (std::size_t n = 0; n < group.m.size(); ++n) {
    group.u.push_back(vector("u", n));
    group.v.push_back(vector("v", n));
  }
  for (std::size_t n = 0; n < c.numbers.at("i").size(); ++n) {
    group.collisions.push_back({static_cast<int>(c.numbers.at("i")[n]),
                                static_cast<int>(c.numbers.at("j")[n]), c.numbers.at("c")[n]});
  }
  return group;
}

bool has_wall(const GroupCase& group) {
  return std::any_of(group.m.begin(), group.m.end(), [](double m) { return std::isinf(m); });
}

// V is the largest relative speed among the bodies at first plus the largest speed; v_load lies between
// velocities, so no load sees more. After k loads a velocity errs by 8u V each (weights 5u, the sum of masses
// 3u); a node's impulse, divided by the mass of its body, by (1 + c) 20u V for eq. (4), twice the velocities'
// error and 12u V for eq. (7); parting adds 2u of speeds of at most (1 + 2k) V: k (32k + 126) u V in all.
Wide error(const GroupCase& group, const Wide& u) {
  Wide V = 0;
  for (const Vec3& v : group.v) V = std::max(V, 3 * norm(wide(v)));
  const auto k = static_cast<int>(group.collisions.size());
  return k * (32 * k + 126) * u * V * kSlack;
}

Outcome velocities_are_those_of_nested_equations(Interview& ask, const Case& c) {
  const GroupCase group = read_group(c);
  const GroupVelocities found = ask.group(group);
  const GroupVelocities expected = nested_loads(group);
  Outcome outcome;
  for (std::size_t n = 0; n < group.m.size(); ++n) {
    const std::string body = " of body " + std::to_string(n);
    outcome = all_of(outcome,
                     at_most("the error of the loaded velocity" + body,
                             norm(found.loaded[n] - expected.loaded[n]), error(group, ask.u())),
                     at_most("the error of the velocity after restitution" + body,
                             norm(found.restituted[n] - expected.restituted[n]), error(group, ask.u())));
  }
  return outcome;
}

struct Sums {
  WideVector momentum{};
  Wide kinetic = 0;
  Wide mass = 0, momenta = 0;  ///< Σm and Σm|v|

  Sums(const std::vector<double>& m, const std::vector<WideVector>& v) {
    for (std::size_t n = 0; n < m.size(); ++n) {
      if (std::isinf(m[n])) continue;
      const Wide m_n(m[n]);
      momentum = momentum + m_n * v[n];
      kinetic += m_n * dot(v[n], v[n]) / 2;
      mass += m_n;
      momenta += m_n * norm(v[n]);
    }
  }
};

std::vector<WideVector> at_first(const GroupCase& group) {
  std::vector<WideVector> v;
  for (const Vec3& each : group.v) v.push_back(wide(each));
  return v;
}

Outcome momentum_is_conserved(Interview& ask, const Case& c) {
  const GroupCase group = read_group(c);
  if (has_wall(group)) return outside("a wall takes momentum");
  const GroupVelocities found = ask.group(group);
  const Sums before(group.m, at_first(group));
  const auto conserved = [&](const char* what, const std::vector<WideVector>& v) {
    const Sums after(group.m, v);
    return at_most(what, norm(after.momentum - before.momentum), after.mass * error(group, ask.u()));
  };
  return all_of(conserved("momentum gained while loaded", found.loaded),
                conserved("momentum gained after restitution", found.restituted));
}

// ½ Σ m v² errs by Σ m |v| e + ½ Σ m e².
Outcome energy_never_rises(Interview& ask, const Case& c) {
  const GroupCase group = read_group(c);
  const GroupVelocities found = ask.group(group);
  const Sums before(group.m, at_first(group)), loaded(group.m, found.loaded),
      after(group.m, found.restituted);
  const Wide e = error(group, ask.u());
  const auto rounding = [&](const Sums& sums) { return (sums.momenta + sums.mass * e) * e; };
  const bool elastic = std::all_of(group.collisions.begin(), group.collisions.end(),
                                   [](const GroupCollision& each) { return each.c == 1; });
  const Wide gained = after.kinetic - before.kinetic;
  return all_of(
      at_most("the energy gained by loading", loaded.kinetic - before.kinetic, rounding(loaded)),
      at_most("the energy lost by restitution", loaded.kinetic - after.kinetic,
              rounding(loaded) + rounding(after)),
      at_most("the energy gained by loading and restitution", gained, rounding(after)),
      at_most("the energy lost where every c is 1", elastic ? Wide(-gained) : Wide(0), rounding(after)));
}

Outcome sibling_order_is_irrelevant(Interview& ask, const Case& c) {
  GroupCase group = read_group(c);
  if (group.collisions.size() < 2) return outside("one collision has no sibling");
  const GroupCollision &first = group.collisions[0], &second = group.collisions[1];
  const auto shares = [&](int n) { return n == second.i || n == second.j; };
  const bool wall = has_wall(group) && std::min({first.i, first.j, second.i, second.j}) == 0;
  if (shares(first.i) || shares(first.j) || wall) return outside("the first two collisions share a body");
  const GroupVelocities one = ask.group(group);
  std::swap(group.collisions[0], group.collisions[1]);
  const GroupVelocities other = ask.group(group);
  Outcome outcome;
  for (std::size_t n = 0; n < group.m.size(); ++n) {
    outcome = all_of(outcome,
                     same_to("loaded velocity, siblings exchanged", other.loaded[n], one.loaded[n],
                             2 * error(group, ask.u())),
                     same_to("velocity after restitution, siblings exchanged", other.restituted[n],
                             one.restituted[n], 2 * error(group, ask.u())));
  }
  return outcome;
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const auto add = [&laws](const char* id, const char* number, const char* sentence, const auto& check) {
    laws.push_back({{id, number, sentence, "docs/protocol.md"}, {Op::group}, cases(put_group), check});
  };
  add("GroupLaws.Law1VelocitiesAreThoseOfNestedEquations", "group law 1",
      "velocities while loaded and after restitution are those of (4), (6), (7) and (3), nested",
      velocities_are_those_of_nested_equations);
  add("GroupLaws.Law2MomentumIsConserved", "group law 2",
      "momentum is conserved, loaded and after restitution", momentum_is_conserved);
  add("GroupLaws.Law3EnergyNeverRises", "group law 3",
      "loading takes kinetic energy, restitution returns some, and all of it where every c is 1",
      energy_never_rises);
  add("GroupLaws.Law4SiblingOrderIsIrrelevant", "group law 4",
      "loads of different bodies may come in any order, bitwise", sibling_order_is_irrelevant);
}

}  // namespace tps::properties::group
