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
  std::vector<std::vector<int>> partners_;
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

  /// Few at a time: they are kept where the particle's list is, without allocating.
  using Entries = boost::container::small_vector<Entry, 3>;

  explicit Responded(const std::vector<bool>& fixed)
      : fixed_(fixed.begin(), fixed.end()),
        entries_(fixed.size()),
        glances_(fixed.size(), {kNobody, Limit::inner}) {}

  bool contains(int i, int j, Limit limit) const { return has(i, {j, limit}) && has(j, {i, limit}); }
  void add(int i, int j, Limit limit) {
    insert(i, {j, limit});
    insert(j, {i, limit});
  }
  /// The velocity of i has changed.
  void forget(int i) {
    entries_[static_cast<std::size_t>(i)].clear();
    glances_[static_cast<std::size_t>(i)] = {kNobody, Limit::inner};
  }
  void prefetch(int i) const { __builtin_prefetch(&glances_[static_cast<std::size_t>(i)]); }
  /// Ascending, so that a full state does not depend on entries that a partner has since made void.
  const Entries& of(int i) const { return entries_[static_cast<std::size_t>(i)]; }

 private:
  bool is_fixed(int i) const { return fixed_[static_cast<std::size_t>(i)] != 0; }
  bool has(int i, Entry entry) const {
    if (is_fixed(i)) return true;
    const Entry& glance = glances_[static_cast<std::size_t>(i)];
    if (glance.partner != kSeveral) return glance == entry;
    return std::binary_search(of(i).begin(), of(i).end(), entry);
  }
  void insert(int i, Entry entry) {
    if (has(i, entry)) return;
    Entries& entries = entries_[static_cast<std::size_t>(i)];
    entries.insert(std::lower_bound(entries.begin(), entries.end(), entry), entry);
    glances_[static_cast<std::size_t>(i)] = entries.size() == 1 ? entry : Entry{kSeveral, Limit::inner};
  }

  static constexpr int kNobody = -1;
  static constexpr int kSeveral = -2;

  std::vector<char> fixed_;
  LargeVector<Entries> entries_;
  LargeVector<Entry> glances_;  ///< a lone entry, nobody, or several: most questions need no list
};

}  // namespace tps
