#include "verify/trace_check/kinds.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/engine/effect_facts.hpp"

namespace tps::check {
namespace {

KindRow row_of(std::size_t number, const KindOfEffect& known) {
  const auto kind = static_cast<Kind>(number);
  return {kind,
          std::string(known.kind.name),
          known.effect,
          known.kind.about,
          is_collision(kind),
          is_collision(kind) && kind != Kind::broken,
          known.kind.own_keys};
}

std::vector<KindRow> all_kinds() {
  std::vector<KindOfEffect> left = event_kinds();
  std::vector<KindRow> rows;
  for (const std::string_view name : {"rebound", "retract", "revolve", "break", "restitute", "wall"}) {
    const auto found =
        std::find_if(left.begin(), left.end(), [&](const KindOfEffect& k) { return k.kind.name == name; });
    if (found == left.end()) throw std::logic_error("no effect records " + std::string(name));
    rows.push_back(row_of(rows.size(), *found));
    left.erase(found);
  }
  for (const KindOfEffect& known : left) rows.push_back(row_of(rows.size(), known));
  return rows;
}

}  // namespace

bool KindRow::owns(std::string_view key) const {
  return std::find(own_keys.begin(), own_keys.end(), key) != own_keys.end();
}

const std::vector<KindRow>& kinds() {
  static const std::vector<KindRow> rows = all_kinds();
  return rows;
}

std::string words(Kind kind) {
  std::string text = name(kind);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace tps::check
