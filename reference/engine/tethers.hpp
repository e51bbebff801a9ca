// Which particles are tethered, and which pairs have just responded: flags of pairs, kept by particle.
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <compare>
#include <utility>
#include <vector>

#include "reference/engine/large_pages.hpp"

namespace tps {

/// The tethers that formed or were listed (permanent ones follow from the pair's law and are not kept).
class Tethers {
 public:
  explicit Tethers(std::size_t particles) : partners_(particles) {}

  bool contains(int i, int j) const {
    const bool i_has_fewer = count(i) <= count(j);
    const std::vector<int>& list = of(i_has_fewer ? i : j);
    return std::binary_search(list.begin(), list.end(), i_has_fewer ? j : i);
  }
  void add(int i, int j) {
    insert(i, j);
    insert(j, i);
  }
  void remove(int i, int j) {
    erase(i, j);
    erase(j, i);
  }
  std::size_t count(int i) const { return of(i).size(); }
  void prefetch(int i) const { __builtin_prefetch(&partners_[static_cast<std::size_t>(i)]); }
  /// The partners of a particle, ascending.
  const std::vector<int>& of(int i) const { return partners_[static_cast<std::size_t>(i)]; }

 private:
  void insert(int i, int j) {
    std::vector<int>& list = partners_[static_cast<std::size_t>(i)];
    list.insert(std::lower_bound(list.begin(), list.end(), j), j);
  }
  void erase(int i, int j) {
    std::vector<int>& list = partners_[static_cast<std::size_t>(i)];
    list.erase(std::lower_bound(list.begin(), list.end(), j));
  }
  LargeVector<std::vector<int>> partners_;
};

/// The two limits of a pair.
enum class Limit : int { inner, outer };

/// Pairs that have responded at a limit and cannot be at it again before one of the two velocities changes
/// (semantics §1, "After a response"). A particle of infinite mass never changes and keeps no list.
class Responded {
 public:
  struct Entry {
    int partner;
    Limit limit;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  /// Few at a time: they are kept where the list is, without allocating.
  using Entries = boost::container::small_vector<Entry, 3>;

  explicit Responded(const std::vector<bool>& fixed) : lists_(fixed.size()) {
    glances_.reserve(fixed.size());
    for (const bool is_fixed : fixed) glances_.push_back({is_fixed ? kEverybody : kNobody, Limit::inner});
  }

  bool contains(int i, int j, Limit limit) const { return has(i, {j, limit}) && has(j, {i, limit}); }
  void add(int i, int j, Limit limit) {
    insert(i, {j, limit});
    insert(j, {i, limit});
  }
  /// The velocity of i has changed.
  void forget(int i) {
    Entry& glance = glances_[index(i)];
    if (glance.partner == kEverybody) return;
    if (glance.partner == kSeveral) lists_[index(i)].clear();
    glance.partner = kNobody;
  }
  void prefetch(int i) const { __builtin_prefetch(&glances_[index(i)]); }
  /// Ascending, so that a full state does not depend on entries that a partner has since made void.
  Entries of(int i) const {
    const Entry& glance = glances_[index(i)];
    if (glance.partner == kSeveral) return lists_[index(i)];
    return glance.partner >= 0 ? Entries{glance} : Entries{};
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  bool has(int i, Entry entry) const {
    const Entry& glance = glances_[index(i)];
    if (glance.partner >= 0) return glance == entry;
    if (glance.partner != kSeveral) return glance.partner == kEverybody;
    return std::binary_search(lists_[index(i)].begin(), lists_[index(i)].end(), entry);
  }
  void insert(int i, Entry entry) {
    if (has(i, entry)) return;
    Entry& glance = glances_[index(i)];
    if (glance.partner == kNobody) {
      glance = entry;
      return;
    }
    Entries& list = lists_[index(i)];
    if (glance.partner >= 0) list.push_back(std::exchange(glance, {kSeveral, Limit::inner}));
    list.insert(std::lower_bound(list.begin(), list.end(), entry), entry);
  }

  // In the place of a partner:
  static constexpr int kNobody = -1;
  static constexpr int kSeveral = -2;    ///< the list says who
  static constexpr int kEverybody = -3;  ///< an infinite mass

  LargeVector<Entry> glances_;  ///< a lone entry, or one of the above: most questions need no list
  LargeVector<Entries> lists_;
};

}  // namespace tps
