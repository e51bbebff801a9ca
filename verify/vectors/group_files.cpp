// The strata of group: loads in order, then the restitution of the whole tree.
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace {

using Vector = std::vector<double>;

struct Body {
  double m;
  Vector u, v;
};

Body random_body(Random& random, bool wall) {
  Body body{HUGE_VAL, {}, {}};
  for (int k = 0; k < 3; ++k) {
    body.u.push_back(random.uniform(-2, 2));
    body.v.push_back(wall ? 0 : random.uniform(-1, 1));
  }
  const double significand = random.uniform(1, 2);
  if (!wall) body.m = std::ldexp(significand, random.integer(-6, 6));
  return body;
}

/// Loads as they are made, in double: enough to know who approaches whom.
class Motion {
 public:
  explicit Motion(const std::vector<Body>& bodies) {
    for (const Body& body : bodies) {
      root_.push_back(static_cast<int>(root_.size()));
      m_.push_back(body.m);
      v_.push_back(body.v);
    }
  }

  bool together(int i, int j) const { return root_[at(i)] == root_[at(j)]; }

  bool approach(const std::vector<Body>& bodies, int i, int j) const {
    double h = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      h += (bodies[at(j)].u[k] - bodies[at(i)].u[k]) * (v_[at(j)][k] - v_[at(i)][k]);
    }
    return h < 0;
  }

  void load(int i, int j) {
    const double share = std::isinf(m_[at(i)])   ? 1
                         : std::isinf(m_[at(j)]) ? 0
                                                 : m_[at(i)] / (m_[at(i)] + m_[at(j)]);
    Vector joint;
    for (std::size_t k = 0; k < 3; ++k) joint.push_back(share * v_[at(i)][k] + (1 - share) * v_[at(j)][k]);
    const double mass = m_[at(i)] + m_[at(j)];
    const int from = root_[at(i)];
    const int to = root_[at(j)];
    for (std::size_t n = 0; n < root_.size(); ++n) {
      if (root_[n] != from && root_[n] != to) continue;
      root_[n] = to;
      m_[n] = mass;
      v_[n] = joint;
    }
  }

 private:
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

  std::vector<int> root_;
  std::vector<double> m_;
  std::vector<Vector> v_;
};

/// A body seen from `centre` on the other side.
void mirror(Body& body, const Body& centre) {
  for (std::size_t k = 0; k < 3; ++k) body.u[k] = 2 * centre.u[k] - body.u[k];
}

Json rebound(int i, int j, double c) {
  return {{"i", i}, {"j", j}, {"limit", "inner"}, {"c", hex(c)}};
}

Json retraction(Random& random, int i, int j) {
  return {{"i", i},
          {"j", j},
          {"limit", "outer"},
          {"c_retract", hex(random.uniform(0, 1))},
          {"c_revolve", hex(random.uniform(0, 1))},
          {"theta_revolve_deg", hex(random.uniform(1, 89))}};
}

double any_restitution(Random& random) {
  const int edge = random.integer(0, 4);
  return edge < 2 ? edge : random.uniform(0, 1);
}

Problem problem_of(const std::vector<Body>& bodies, const Json& collisions, std::vector<std::string> tags) {
  Json list = Json::array();
  for (const Body& body : bodies)
    list.push_back({{"m", hex(body.m)}, {"u", hex(body.u)}, {"v", hex(body.v)}});
  return {{{"bodies", list}, {"collisions", collisions}}, std::move(tags)};
}

/// Takes up one body after the other: as many nested restitutions as there are collisions. The last one may
/// be a wall.
Problem one_after_the_other(Random& random, int loads, bool ends_on_wall) {
  std::vector<Body> bodies{random_body(random, false)};
  for (int n = 1; n <= loads; ++n) bodies.push_back(random_body(random, ends_on_wall && n == loads));
  Motion motion(bodies);
  Json collisions = Json::array();
  for (int n = 1; n <= loads; ++n) {
    const int partner = random.integer(0, n - 1);
    Body& next = bodies[static_cast<std::size_t>(n)];
    if (!motion.approach(bodies, partner, n)) mirror(next, bodies[static_cast<std::size_t>(partner)]);
    collisions.push_back(rebound(partner, n, any_restitution(random)));
    motion.load(partner, n);
  }
  return problem_of(bodies, collisions, {ends_on_wall ? "wall" : "chain", "depth " + std::to_string(loads)});
}

Problem chain(Random& random, std::uint64_t number) {
  return one_after_the_other(random, 1 + static_cast<int>(number % 8), false);
}
Problem wall(Random& random, std::uint64_t number) {
  return one_after_the_other(random, 1 + static_cast<int>(number % 4), true);
}

/// Collisions between any two bodies until one tree is left: rebounds of those that approach, retractions or
/// revolutions of the others.
Json until_one_tree(Random& random, const std::vector<Body>& bodies) {
  const int size = static_cast<int>(bodies.size());
  Motion motion(bodies);
  Json collisions = Json::array();
  while (static_cast<int>(collisions.size()) < size - 1) {
    const int i = random.integer(0, size - 1);
    const int j = random.integer(0, size - 1);
    if (motion.together(i, j)) continue;
    const bool inner = motion.approach(bodies, i, j);
    collisions.push_back(inner ? rebound(i, j, any_restitution(random)) : retraction(random, i, j));
    motion.load(i, j);
  }
  return collisions;
}

Problem tree(Random& random, std::uint64_t number) {
  const int size = 2 + static_cast<int>(number % 8);
  std::vector<Body> bodies;
  for (int n = 0; n < size; ++n) bodies.push_back(random_body(random, false));
  return problem_of(bodies, until_one_tree(random, bodies), {"tree"});
}

/// A container, or a wall, among few bodies: they rebound from it or are pulled back by it, in any order.
Problem membrane(Random& random, std::uint64_t number) {
  const int size = 2 + static_cast<int>(number % 4);
  const int infinite = random.integer(0, size - 1);
  std::vector<Body> bodies;
  for (int n = 0; n < size; ++n) bodies.push_back(random_body(random, n == infinite));
  return problem_of(bodies, until_one_tree(random, bodies), {"membrane"});
}

}  // namespace

void add_group_strata(std::vector<Stratum>& strata) {
  strata.push_back({Op::group, "chain", "loads one after the other, to depth 8", 80, chain});
  strata.push_back({Op::group, "tree", "loads of groups with groups", 80, tree});
  strata.push_back({Op::group, "wall", "a group that ends grounded on an infinite mass", 60, wall});
  strata.push_back({Op::group, "membrane", "outer and inner collisions of few bodies, one of infinite mass",
                    40, membrane});
}

}  // namespace tps::vectors
