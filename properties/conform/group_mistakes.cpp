// Mistakes in groups: the whole of eqs. (4), (6), (7) and (3), nested, with one switch each.
#include <algorithm>

#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {
namespace {

struct Switches {
  bool single_mass = false;     ///< the mass of the particle, not that of its group
  bool no_subtraction = false;  ///< of eq. (7)
  bool elastic = false;         ///< c taken as 1
  bool pair_alone = false;      ///< the two particles take the common velocity, their groups do not
};

struct Node {
  std::vector<std::size_t> i, j;
  double m_i, m_j;
  Vec dp;
};

/// Inner collisions of finite masses alone: that is where these mistakes show.
std::optional<Mistaken> group(const Given& g, const Switches& s) {
  std::vector<double> m, own;
  std::vector<Vec> u, v;
  std::vector<std::vector<std::size_t>> members;
  for (const Json& body : g.in().at("bodies")) {
    const Given b(body);
    if (std::isinf(b.number("m"))) return std::nullopt;
    m.push_back(b.number("m"));
    u.push_back(b.vec("u"));
    v.push_back(b.vec("v"));
    members.push_back({members.size()});
  }
  own = m;
  std::vector<Node> nodes;
  for (const Json& c : g.in().at("collisions")) {
    if (c.value("limit", "inner") == "outer") return std::nullopt;
    const auto i = c.at("i").get<std::size_t>(), j = c.at("j").get<std::size_t>();
    const double m_i = s.single_mass ? own[i] : m[i], m_j = s.single_mass ? own[j] : m[j];
    const double mu = 1 / (1 / m_i + 1 / m_j);
    const Vec r = u[j] - u[i], n = (1 / norm(r)) * r, apart = v[j] - v[i];
    const Vec dp = ((1 + (s.elastic ? 1 : Given(c).number("c"))) * mu * dot(apart, n)) * n;
    nodes.push_back({members[i], members[j], m_i, m_j, s.no_subtraction ? dp : dp - mu * apart});
    const Vec joint = (1 / (1 + m_j / m_i)) * v[i] + (1 / (1 + m_i / m_j)) * v[j];
    const double mass = m[i] + m[j];
    std::vector<std::size_t> all = members[i];
    all.insert(all.end(), members[j].begin(), members[j].end());
    for (const std::size_t k : all) {
      if (!s.pair_alone || k == i || k == j) v[k] = joint;
      m[k] = mass;
      members[k] = all;
    }
  }
  const auto flat = [&] {
    Vec all;
    for (const Vec& each : v) all.insert(all.end(), each.begin(), each.end());
    return all;
  };
  Mistaken answer{{{"loaded", flat()}}};
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    for (const std::size_t k : node->i) v[k] = v[k] + (1 / node->m_i) * node->dp;
    for (const std::size_t k : node->j) v[k] = v[k] - (1 / node->m_j) * node->dp;
  }
  answer.numbers.emplace_back("restituted", flat());
  return answer;
}

}  // namespace

void add_group_mistakes(std::vector<Mistake>& mistakes) {
  const auto add = [&](std::string name, Switches switches) {
    mistakes.push_back(
        {std::move(name), {Op::group}, [switches](const Given& g) { return group(g, switches); }});
  };
  add("the mass of one particle instead of its group's", {.single_mass = true});
  add("(7) without its subtraction", {.no_subtraction = true});
  add("c taken as 1", {.elastic = true});
  add("only the two particles take the common velocity, not their groups", {.pair_alone = true});
}

}  // namespace tps::properties::conform
