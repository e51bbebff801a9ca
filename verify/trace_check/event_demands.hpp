// What a line of an event has to have by its kind, and must not have.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "verify/trace_check/line.hpp"
#include "verify/trace_check/line_values.hpp"

namespace tps::check {

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
    forbid(e_.face && row_.own_key != "wall", "face");
    if (row_.about == About::pair || row_.about == About::particle) {
      particles();
      impulses();
      tethers();
    } else {
      forbid(e_.i >= 0, "i");
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

  void own(bool there, std::string_view key) const {
    need(there || row_.own_key != key, key);
    forbid(there && row_.own_key != key, key);
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
