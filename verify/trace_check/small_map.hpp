// A map of few entries, in the order of its keys, that keeps its memory when it is emptied.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace tps::check {

/// What std::map does, at the cost of going through the entries.
template <typename Key, typename Value>
class SmallMap {
 public:
  Value& operator[](const Key& key) {
    const auto place = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const auto& entry) { return !(entry.first < key); });
    if (place != entries_.end() && place->first == key) return place->second;
    return entries_.insert(place, {key, Value()})->second;
  }
  /// Null where there is no such entry.
  const Value* find(const Key& key) const {
    for (const auto& [known, value] : entries_) {
      if (known == key) return &value;
    }
    return nullptr;
  }

  bool empty() const { return entries_.empty(); }
  void clear() { entries_.clear(); }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }

 private:
  std::vector<std::pair<Key, Value>> entries_;
};

}  // namespace tps::check
