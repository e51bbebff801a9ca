#include "reference/trace/check_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/trace/exact_text.hpp"

namespace tps {
namespace {

/// The particles below a side, and whether one of them met an infinite mass.
struct Below {
  std::vector<std::int32_t> members;
  bool grounded = false;
};

class Tree {
 public:
  Tree(const StateData::Group& group, const std::function<double(std::int32_t)>& mass_of, int digits)
      : group_(group), mass_of_(mass_of), digits_(digits) {}

  std::optional<GroupProblem> problem() {
    if (group_.members.empty() || group_.nodes.empty()) return GroupProblem{"", "has no members or no nodes"};
    if (std::adjacent_find(group_.members.begin(), group_.members.end(), std::greater_equal<>()) !=
        group_.members.end()) {
      return GroupProblem{"/members", "are not ascending"};
    }
    // Children stand behind their parents: from the last to the first, what is below a node is known.
    below_.resize(group_.nodes.size());
    std::vector<int> parents(group_.nodes.size(), 0);
    for (std::size_t n = group_.nodes.size(); n-- > 0;) {
      if (const auto wrong = problem_of_node(n, parents)) return wrong;
    }
    for (std::size_t n = 1; n < parents.size(); ++n) {
      if (parents[n] != 1)
        return GroupProblem{fmt::format("/nodes/{}", n), "is not below exactly one other: nodes are a tree"};
    }
    if (below_[0].members != group_.members)
      return GroupProblem{"/members", "are not the particles of the nodes"};
    if (!is_mass(group_.mass, below_[0])) return GroupProblem{"/mass", "is not that of the members"};
    return std::nullopt;
  }

 private:
  std::optional<GroupProblem> problem_of_node(std::size_t n, std::vector<int>& parents) {
    const StateData::Node& node = group_.nodes[n];
    const std::string pointer = fmt::format("/nodes/{}", n);
    for (std::size_t s = 0; s < 2; ++s) {
      const StateData::Side& side = node.sides[s];
      const std::string at = fmt::format("{}/sides/{}", pointer, s);
      const std::int32_t own = s == 0 ? node.i : node.j;
      const bool infinite = std::isinf(mass_of_(own));
      Below below;
      if (side.node) {
        const auto child = static_cast<std::size_t>(*side.node);
        if (child <= n || child >= group_.nodes.size())
          return GroupProblem{at, "is no node behind this one: nodes are a tree, the root first"};
        ++parents[child];
        below = below_[child];
      } else if (side.particle) {
        below.members = {*side.particle};
      } else {
        below.grounded = true;
      }
      const bool own_side = infinite ? !side.node && !side.particle
                                     : std::binary_search(below.members.begin(), below.members.end(), own);
      if (!own_side) return GroupProblem{at, fmt::format("does not hold particle {}, whose side it is", own)};
      if (!is_mass(node.masses[s], below))
        return GroupProblem{fmt::format("{}/masses/{}", pointer, s), "is not that of the particles below"};
      Below& all = below_[n];
      std::vector<std::int32_t> merged;
      std::merge(all.members.begin(), all.members.end(), below.members.begin(), below.members.end(),
                 std::back_inserter(merged));
      all.members = std::move(merged);
      all.grounded = all.grounded || below.grounded;
    }
    return std::nullopt;
  }

  bool is_mass(const Hex& mass, const Below& below) const {
    if (below.grounded || mass == "inf" || mass == "-inf") return below.grounded && mass == "inf";
    std::vector<HexDigits> sum;
    for (const std::int32_t id : below.members) sum.push_back(hex_digits(mass_of_(id)));
    const HexDigits exact = exact_sum(sum);
    HexDigits stated = split_hex(mass).value();
    if (stated.negative) return false;
    HexDigits minus_exact = exact;
    minus_exact.negative = true;
    HexDigits off = exact_sum(std::vector<HexDigits>{stated, minus_exact});
    off.negative = false;
    // n u/(1 − n u) ≤ 2 n u ≤ 2^(1 + ⌈log2 n⌉) u.
    HexDigits allowed = minus_exact;
    allowed.exponent += 1 - digits_;
    for (std::size_t n = 1; n < below.members.size(); n *= 2) ++allowed.exponent;
    return sign_of_sum({off, allowed}) <= 0;
  }

  const StateData::Group& group_;
  const std::function<double(std::int32_t)>& mass_of_;
  int digits_;
  std::vector<Below> below_;
};

}  // namespace

std::optional<GroupProblem> group_problem(const StateData::Group& group,
                                          const std::function<double(std::int32_t)>& mass_of, int digits) {
  return Tree(group, mass_of, digits).problem();
}

std::optional<std::string> expiry_problem(const HexTime& expiry, const HexTime& now, double dt, int digits,
                                          bool of_our_run) {
  if (std::isinf(dt) && expiry[0] == "inf") return std::nullopt;
  if (expiry[0] == "inf" || !is_normal_time(expiry, digits) || !is_not_after(now, expiry))
    return "is no time, or before \"now\": the body would have parted";
  if (std::isinf(dt) || is_not_after_sum(expiry, now, dt, digits, of_our_run ? 2 * digits - 2 : digits - 1))
    return std::nullopt;
  return "is later than \"now\" + dt_restitute, which no load sets";
}

}  // namespace tps
