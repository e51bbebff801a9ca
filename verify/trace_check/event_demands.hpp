// What a line of an event has to have by its kind, and must not have.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "verify/trace_check/line.hpp"
#include "verify/trace_check/line_values.hpp"

namespace tps::check {

/// Keys that the reader knows, whatever the effects are. Another one is a field of an effect's own.
inline const std::vector<std::string>& event_keys() {
  static const std::vector<std::string> keys = {
      "k",         "t",  "dt",     "kind", "i",       "j", "phase", "pre",  "post", "dp",
      "dp_stored", "dv", "tether", "draw", "members", "s", "ds",    "wall", "face", "contact"};
  return keys;
}

/// Throws LineProblem. `minimal` as the trace's header says; `drag` whether its scene has drag, whose clock
/// is s.
template <typename Number>
class EventDemands {
 public:
  EventDemands(const EventLine<Number>& event, bool minimal, bool drag)
      : e_(event), row_(row(event.kind)), minimal_(minimal), drag_(drag) {}

  void demand() const {
    if (!minimal_) {
      need(e_.k.has_value(), "k");
      need(e_.dt.has_value(), drag_ ? "ds" : "dt");
    }
    own(e_.phase.has_value(), "phase");
    own(e_.wall.has_value(), "wall");
    if (!minimal_ || e_.dv) own(e_.dv.has_value(), "dv");
    forbid(e_.face && e_.kind != Kind::wall, "face");
    for (const OwnValue<Number>& value : e_.own) forbid(!row_.owns(value.key), value.key);
    for (const std::string_view key : row_.own_keys) {
      if (!is_common(key)) need(minimal_ || e_.value_of(key) != nullptr, key);
    }
    if (row_.about == About::pair || row_.about == About::particle) {
      particles();
      impulses();
      tethers();
    } else {
      forbid(e_.i >= 0, "i");
      forbid(e_.j >= 0, "j");
      forbid(!e_.involved.empty(), "post");
    }
  }

 private:
  void particles() const {
    const bool alone = row_.about == About::particle;
    need(e_.i >= 0, "i");
    need(e_.j >= 0 || alone, "j");
    forbid(e_.j >= 0 && alone, "j");
    if (!alone && e_.i >= e_.j) problem("i", "is not below j; a pair is named in the order of its ids");
    need(e_.of(e_.i) != nullptr, "post of i");
    need(alone || e_.of(e_.j) != nullptr, "post of j");
    if (!minimal_) need(e_.of(e_.i)->position_before.has_value(), "pre");
  }

  void impulses() const {
    const bool has_none = e_.kind == Kind::broken;
    if (!minimal_) {
      need(e_.dp || has_none, "dp");
      need(!e_.members.empty() || !e_.dp_stored, "members");
    }
    forbid(e_.dp && has_none, "dp");
    forbid(e_.dp_stored && !row_.responds, "dp_stored");
    forbid(!e_.members.empty() && !row_.responds, "members");
  }

  void tethers() const {
    forbid(e_.draw && !row_.collides, "draw");
    if (e_.kind == Kind::broken && e_.formed.value_or(!minimal_))
      problem("tether", "of a break is \"broken\"");
    if (e_.formed && *e_.formed && e_.kind != Kind::rebound) problem("tether", "forms at a rebound only");
    if (e_.formed && !*e_.formed && e_.kind != Kind::broken) problem("tether", "breaks at a break only");
  }

  static bool is_common(std::string_view key) {
    return std::find(event_keys().begin(), event_keys().end(), key) != event_keys().end();
  }
  void own(bool there, std::string_view key) const {
    need(there || !row_.owns(key), key);
    forbid(there && !row_.owns(key), key);
  }
  void need(bool there, std::string_view key) const {
    if (!there) problem(kLine, fmt::format("lacks \"{}\", which a {} has", key, row_.name));
  }
  void forbid(bool there, std::string_view key) const {
    if (there) problem(Pointer{&kLine, key}, fmt::format("is not for a {}", row_.name));
  }

  const EventLine<Number>& e_;
  const KindRow& row_;
  bool minimal_, drag_;
};

}  // namespace tps::check
