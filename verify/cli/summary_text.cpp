#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "reference/text/printable.hpp"
#include "verify/cli/summary.hpp"

namespace tps::cli {
namespace {

using Text = std::back_insert_iterator<std::string>;

std::string verdict(double value, double bound) {
  return value <= bound ? "within" : "BEYOND";
}

/// Positive excess in ulps; what is inside the bound needs no number.
std::string excess(double ulps) {
  return ulps > 0 ? fmt::format("{:.2g} ulp", ulps) : "none";
}

void write_conservation(Text out, const RunSummary& s) {
  fmt::format_to(
      out, "energy     kinetic {:.6g} -> {:.6g}, lost {:.6g}, stored {:.6g}, work from outside {:.6g}\n",
      s.kinetic_at_start, s.kinetic, s.lost, s.stored, s.work);
  if (s.spin) fmt::format_to(out, "           of spins {:.6g} -> {:.6g}\n", *s.spin_at_start, *s.spin);
  for (std::size_t n = 0; n < s.by_effect.size(); ++n) {
    const EffectEnergy& share = s.by_effect[n];
    const bool goes_on = n > 0 && s.by_effect[n - 1].effect == share.effect;
    fmt::format_to(out, "{}{} {:.6g}", goes_on ? ", " : fmt::format("           {}: ", share.effect),
                   share.what, share.energy);
    const bool ends = n + 1 == s.by_effect.size() || s.by_effect[n + 1].effect != share.effect;
    if (ends) fmt::format_to(out, "\n");
  }
  fmt::format_to(out, "           remainder {:.2e}, {} its bound {:.2e}\n", s.energy_remainder,
                 verdict(std::abs(s.energy_remainder), s.energy_bound), s.energy_bound);
  fmt::format_to(out, "momentum   drift {:.2e}, {} its bound {:.2e}\n", s.momentum_drift,
                 verdict(s.momentum_drift, s.momentum_bound), s.momentum_bound);
  fmt::format_to(out, "distances  beyond the inner limit: {} at events, {} at the end\n",
                 excess(s.worst_inner_excess), excess(s.audit_inner_excess));
  fmt::format_to(out, "           beyond the outer limit: {} at events, {} at the end\n",
                 excess(s.worst_outer_excess), excess(s.audit_outer_excess));
}

void write_certified(Text out, const TimingCounters& counters) {
  const auto stages = [&](const char* head, const char* questions, const StageCounts& counts) {
    fmt::format_to(out, "{:<11}{}: {} asked, {} beyond doubles, {} by integers\n", head, questions,
                   counts.calls, counts.uncertain, counts.exact);
  };
  stages("certified", "verdicts", counters.verdict);
  stages("", "times", counters.time);
  stages("", "orders", counters.order);
  if (counters.largest_bits > 0) {
    fmt::format_to(out, "           largest integer {} bits\n", counters.largest_bits);
  }
}

void write_groups(Text out, const RunSummary& s) {
  const double age = s.oldest_group / s.dt_restitute;
  fmt::format_to(out,
                 "groups     largest {} of {} particles, oldest {:.3g} dt_restitute, {} live at the end\n",
                 s.largest_group, s.particles, age, s.live_groups);
  constexpr double kOldGroup = 10;  // semantics §4
  constexpr std::uint64_t kLargeGroup = 10;
  constexpr std::uint64_t kManyParticles = 30;  // in a handful every group is a tenth of them
  if (age > kOldGroup || (s.particles >= kManyParticles && s.largest_group * kLargeGroup >= s.particles)) {
    fmt::format_to(out,
                   "           warning: a group held a tenth of the particles or outlived 10 dt_restitute; "
                   "dt_restitute is too large for this scene\n");
  }
}

void write_clusters(Text out, const RunSummary& s) {
  if (s.clusters.empty()) return;
  fmt::format_to(out,
                 "clusters   of {}; extent and speeds are those of the largest, around an impulse of the one "
                 "that was hit\n",
                 printable(s.cluster_species));
  fmt::format_to(out, "           {:>10}  {:>6}  {:>8}  {:>8}  {:>8}  sizes\n", "t", "number", "extent",
                 "relative", "centre");
  for (const ClusterSample& c : s.clusters) {
    fmt::format_to(out, "           {:>10.5g}  {:>6}", c.t, c.sizes.size());
    if (c.described == 0) {
      fmt::format_to(out, "{:>30}", "");
    } else {
      fmt::format_to(out, "  {:>8.4g}  {:>8.4g}  {:>8.4g}", c.extent, c.relative_speed, c.centre_speed);
    }
    fmt::format_to(out, "  {}{}\n", fmt::join(c.sizes, " "),
                   c.occasion == "sample" ? "" : "  (" + printable(c.occasion) + ")");
  }
}

void write_final(Text out, const RunSummary& s) {
  for (const RunSummary::Final& p : s.final_states) {
    fmt::format_to(out, "particle   {} ({}) at ({}) with velocity ({})\n", p.id, printable(p.species),
                   fmt::join(p.position, ", "), fmt::join(p.velocity, ", "));
  }
}

}  // namespace

namespace {

/// What a scene has that no group can be part of, where its run shows it: then grouping is no advice.
const char* refuses_grouping(const RunSummary& s) {
  if (s.by_kind.contains("wall")) return "walls";
  if (s.by_kind.contains("thermostat")) return "a thermostat";
  if (s.drag_taken) return "drag";
  return s.spin ? "friction" : nullptr;
}

}  // namespace

std::string stall_message(const RunSummary& s) {
  std::string remedy =
      "give the scene \"grouping\" with a small \"dt_restitute\", or run with a wider --scalar.";
  if (const char* refused = refuses_grouping(s)) {
    remedy = fmt::format(
        "raise the restitution, or run with a wider --scalar, or end earlier with --until; \"grouping\", "
        "which "
        "ends a collapse, is not defined with {}.",
        refused);
    if (refused == std::string_view("walls"))
      remedy +=
          " In the place of the inside of a sphere a permanent tether to an infinite mass may hold the "
          "particles.";
  }
  return fmt::format(
      "the clock stood still at t = {:.9g} over the last events, between particles {}. An inelastic "
      "collapse, or its finite number of collisions is beyond this scalar: {}",
      s.t, printable(fmt::format("{}", fmt::join(s.stalled_on, ", "))), remedy);
}

std::string range_message(const RunSummary& s) {
  return fmt::format(
      "{} leaves the range of {} in the event after number {} (t = {:.9g}); the trace ends before it. Choose "
      "other units, or run with a wider --scalar.",
      s.out_of_range, s.scalar, s.events, s.t);
}

std::string rounding_note(const RunSummary& s) {
  if (s.noise == 0) return {};
  const bool widest = s.scalar == scalar_names().back();
  return fmt::format(
      "{} of the rebounds, the first at event {}, approached more slowly than {} can tell: the number of "
      "collisions is not to be trusted from there on; {}",
      s.noise, s.first_noise, s.scalar,
      refuses_grouping(s) != nullptr ? (widest ? "no scalar is wider" : "compare a wider --scalar")
      : widest                       ? "give the scene \"grouping\""
                                     : "compare a wider --scalar, or give the scene \"grouping\"");
}

bool conserves(const RunSummary& s) {
  return std::abs(s.energy_remainder) <= s.energy_bound && s.momentum_drift <= s.momentum_bound;
}

std::string summary_text(const RunSummary& s) {
  std::string text;
  const Text out = std::back_inserter(text);
  fmt::format_to(out, "scene      {} ({} particles, {})\n", s.title.empty() ? "untitled" : printable(s.title),
                 s.particles, s.scalar);
  fmt::format_to(out, "end        {} at t = {:.9g} after {} events", s.end, s.t, s.events);
  if (s.seconds > 0)
    fmt::format_to(out, " ({:.3g} events/s)", static_cast<double>(s.events_here) / s.seconds);
  fmt::format_to(out, "\nevents    ");
  for (const auto& [kind, count] : s.by_kind) fmt::format_to(out, " {} {}", count, kind);
  fmt::format_to(out, "\n           below rounding {}, with zero impulse {}\n", s.noise, s.zero_impulse);
  if (s.noise > 0) fmt::format_to(out, "           note: {}\n", rounding_note(s));
  write_conservation(out, s);
  if (s.certified) write_certified(out, *s.certified);
  if (s.grouping) write_groups(out, s);
  if (s.observes_clusters) write_clusters(out, s);
  write_final(out, s);
  if (!s.out_of_range.empty()) fmt::format_to(out, "range      {}\n", range_message(s));
  if (!s.stalled_on.empty()) fmt::format_to(out, "stalled    {}\n", stall_message(s));
  return text;
}

}  // namespace tps::cli
