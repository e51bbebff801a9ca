// The bodies of a run as the check follows them: trees of loads, their expiry, and what is parting just now.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "verify/trace_check/number.hpp"

namespace tps::check {

/// One load. Side 0 is the body of particle i, side 1 that of j.
template <typename Number>
struct LoadNode {
  int i, j;
  bool outer;
  std::array<std::vector<int>, 2> members;   ///< of the sides; empty for an infinite mass
  std::array<Work<Number>, 2> inverse_mass;  ///< of the two bodies
  Work<Number> speeds{0};                    ///< of the two bodies before the load
  Vec<Number> dp;                            ///< Δp_AB on side 0, eq. (7), as recorded
  Vec<Work<Number>> dp_exact;                ///< the same where nothing is recorded
  Work<Number> dp_error{0};                  ///< of that
  Work<Number> speed_error{
      0};  ///< of μ |v_AB'| where nothing is recorded: less, where only its direction is open
  Work<Number> energy_error{0};  ///< beyond that
  bool recorded = true;
  std::array<std::unique_ptr<LoadNode>, 2> below;  ///< the loads that made the sides
};

template <typename Number>
struct Body {
  std::unique_ptr<LoadNode<Number>> root;
  std::vector<int> members;  ///< ascending
  Work<Number> inverse_mass;
  int loads = 0;
  Instant<Number> expiry;  ///< Δt_restitute after its latest load
  Instant<Number> birth;   ///< its oldest load
};

/// Particles by body. A parting body has lost its root; what its sides were are bodies of no expiry.
template <typename Number>
class GroupModel {
 public:
  using Node = LoadNode<Number>;

  explicit GroupModel(std::size_t particles) : body_of_(particles, nullptr) {}
  GroupModel(const GroupModel&) = delete;
  GroupModel& operator=(const GroupModel&) = delete;

  const Body<Number>* body(int i) const { return body_of_[at(i)]; }
  bool together(int i, int j) const { return body(i) != nullptr && body(i) == body(j); }

  /// Makes one body of the sides of a node; sides of infinite mass have no members.
  void load(std::unique_ptr<Node> node, Work<Number> inverse_mass, const Instant<Number>& now,
            const Instant<Number>& expiry) {
    auto joined = std::make_unique<Body<Number>>();
    joined->inverse_mass = inverse_mass;
    joined->expiry = expiry;
    joined->birth = now;
    joined->loads = 1;
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<int> merged;
      std::merge(joined->members.begin(), joined->members.end(), node->members[side].begin(),
                 node->members[side].end(), std::back_inserter(merged));
      joined->members = std::move(merged);
      Body<Number>* old = node->members[side].empty() ? nullptr : body_of_[at(node->members[side].front())];
      if (old == nullptr) continue;
      joined->loads += old->loads;
      if (old->birth < joined->birth) joined->birth = old->birth;
      node->below[side] = std::move(old->root);
      drop(old);
    }
    joined->root = std::move(node);
    keep(std::move(joined));
  }

  /// The live body whose turn to expire comes first, parting ones aside; null if there is none.
  const Body<Number>* first_to_expire() const {
    return by_expiry_.empty() ? nullptr : by_expiry_.begin()->body;
  }

  /// Takes the root off the tree over particles i and j (which are its pair) and leaves its sides as bodies
  /// of their own, parting at once. REQUIRES body(i) or body(j) has such a root.
  std::unique_ptr<Node> part(Body<Number>* body) {
    std::unique_ptr<Node> node = std::move(body->root);
    drop(body);
    for (std::size_t side = 0; side < 2; ++side) {
      if (node->below[side] == nullptr) continue;
      auto rest = std::make_unique<Body<Number>>();
      rest->root = std::move(node->below[side]);
      rest->members = node->members[side];
      rest->inverse_mass = node->inverse_mass[side];
      parting_.insert(rest.get());
      keep(std::move(rest));
    }
    return node;
  }

  /// The body whose root is the node of i and j; null if there is none.
  Body<Number>* with_root(int i, int j) const {
    for (const int particle : {i, j}) {
      Body<Number>* candidate = body_of_[at(particle)];
      if (candidate != nullptr && candidate->root->i == i && candidate->root->j == j) return candidate;
    }
    return nullptr;
  }

  bool is_parting(const Body<Number>* body) const { return parting_.contains(body); }
  /// Bodies that have begun to part and have not ended.
  const std::set<Body<Number>*, std::less<>>& parting() const { return parting_; }

  /// A body whose expiry a broken trace has passed over is not waited for any more.
  void stop_waiting_for(const Body<Number>* body) {
    by_expiry_.erase({body->expiry, body->members.front(), body});
  }

  /// Gives up what a broken trace has left half parted.
  void forget_parting() {
    while (!parting_.empty()) drop(*parting_.begin());
  }

  std::size_t size() const { return bodies_.size(); }
  std::vector<const Body<Number>*> bodies() const {
    std::vector<const Body<Number>*> all;
    for (const auto& [address, owned] : bodies_) all.push_back(address);
    std::sort(all.begin(), all.end(), [](const Body<Number>* a, const Body<Number>* b) {
      return a->members.front() < b->members.front();
    });
    return all;
  }

 private:
  struct ByExpiry {
    Instant<Number> expiry;
    int first;
    const Body<Number>* body;
    bool operator<(const ByExpiry& other) const {
      if (expiry < other.expiry || other.expiry < expiry) return expiry < other.expiry;
      return first < other.first;
    }
  };

  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

  void keep(std::unique_ptr<Body<Number>> body) {
    for (const int member : body->members) body_of_[at(member)] = body.get();
    if (parting_.count(body.get()) == 0) by_expiry_.insert({body->expiry, body->members.front(), body.get()});
    const Body<Number>* address = body.get();
    bodies_.emplace(address, std::move(body));
  }
  void drop(Body<Number>* body) {
    for (const int member : body->members) body_of_[at(member)] = nullptr;
    by_expiry_.erase({body->expiry, body->members.front(), body});
    parting_.erase(body);
    bodies_.erase(body);
  }

  std::vector<Body<Number>*> body_of_;
  std::map<const Body<Number>*, std::unique_ptr<Body<Number>>> bodies_;
  std::set<ByExpiry> by_expiry_;
  std::set<Body<Number>*, std::less<>> parting_;
};

}  // namespace tps::check
