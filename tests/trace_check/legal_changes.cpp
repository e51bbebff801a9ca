// Changes of a trace that leave what it says as it was.
#include <algorithm>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

std::vector<int> concerned(const Place& place, const Json& event) {
  std::vector<int> ids = place.before.body(event.at("i"));
  if (!event.contains("j")) return ids;
  const std::vector<int> others = place.before.body(event.at("j"));
  ids.insert(ids.end(), others.begin(), others.end());
  return ids;
}

bool share_nobody(const Place& place) {
  const std::vector<int> first = concerned(place, place.event);
  const std::vector<int> second = concerned(place, *place.next);
  return std::ranges::find_first_of(first, second) == first.end();
}

bool next_is_now(const Place& place) {
  return place.next_follows_at_once() && place.until_next() == 0;
}

void exchange_with_next(Trace& trace, std::size_t line) {
  trace.lines.swap(line, line + 1);
  settle(trace);
}

bool parts(const Json& event) {
  return event.at("kind") == "restitute";
}

/// Two nodes below one node: the event before parts a member of each.
bool are_siblings(const Place& place) {
  if (!parts(place.event) || place.previous == nullptr || !parts(*place.previous)) return false;
  if (!next_is_now(place) || !parts(*place.next) || place.since_previous() > 0) return false;
  const std::vector<int> parted = {place.previous->at("i"), place.previous->at("j")};
  const auto holds_one = [&](const Json& event) {
    const std::vector<int> ids = concerned(place, event);
    return std::ranges::find_first_of(ids, parted) != ids.end();
  };
  return share_nobody(place) && holds_one(place.event) && holds_one(*place.next);
}

bool siblings_exchanged(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, are_siblings);
  if (found) exchange_with_next(trace, found->line);
  return found.has_value();
}

Json with_keys_turned_round(const Json& object) {
  std::vector<std::pair<std::string, Json>> entries;
  for (const auto& [name, value] : object.items()) {
    entries.emplace_back(name, value.is_object() ? with_keys_turned_round(value) : value);
  }
  Json turned = Json::object();
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) turned[entry->first] = entry->second;
  return turned;
}

bool keys_turned_round(Trace& trace, std::uint64_t) {
  for (std::size_t n = 0; n < trace.lines.size(); ++n) {
    trace.lines.change(n) = with_keys_turned_round(trace.lines[n]);
  }
  return true;
}

}  // namespace

const std::vector<Legal>& legal_changes() {
  static const std::vector<Legal> list = {
      {"siblings_exchanged", "two nodes of a group below one, in the other order", siblings_exchanged},
      {"keys_turned_round", "the keys of every line in the opposite order", keys_turned_round},
  };
  return list;
}

}  // namespace tps::mutation
