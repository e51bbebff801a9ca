#include <nlohmann/json.hpp>

#include "reference/text/plain_json.hpp"
#include "verify/cli/summary.hpp"

namespace tps::cli {

using json = nlohmann::ordered_json;

namespace {

json clusters_json(const RunSummary& s) {
  json samples = json::array();
  for (const ClusterSample& c : s.clusters) {
    samples.push_back({{"t", c.t},
                       {"occasion", c.occasion},
                       {"sizes", c.sizes},
                       {"described", c.described},
                       {"particles", c.particles},
                       {"mass", c.mass},
                       {"extent", c.extent},
                       {"relative_speed", c.relative_speed},
                       {"centre_speed", c.centre_speed},
                       {"centre_velocity", c.centre_velocity}});
  }
  return {{"species", s.cluster_species}, {"samples", samples}};
}

json stages_json(const StageCounts& counts) {
  return {{"calls", counts.calls}, {"uncertain", counts.uncertain}, {"exact", counts.exact}};
}

}  // namespace

std::string summary_json(const RunSummary& s) {
  json result{{"title", s.title},
              {"scalar", s.scalar},
              {"end", s.end},
              {"t", s.t},
              {"t_exact", s.exact_t},
              {"events", s.events},
              {"by_kind", s.by_kind},
              {"seconds", s.seconds},
              {"events_per_second", s.seconds > 0 ? static_cast<double>(s.events_here) / s.seconds : 0},
              {"momentum", {{"drift", s.momentum_drift}, {"bound", s.momentum_bound}}},
              {"energy",
               {{"kinetic_at_start", s.kinetic_at_start},
                {"kinetic", s.kinetic},
                {"stored", s.stored},
                {"lost", s.lost},
                {"work", s.work},
                {"remainder", s.energy_remainder},
                {"bound", s.energy_bound}}},
              {"worst_excess_ulps",
               {{"inner_at_events", s.worst_inner_excess},
                {"outer_at_events", s.worst_outer_excess},
                {"inner_at_end", s.audit_inner_excess},
                {"outer_at_end", s.audit_outer_excess}}},
              {"noise", s.noise},
              {"first_noise", s.first_noise},
              {"zero_impulse", s.zero_impulse}};
  if (s.spin) {
    result["energy"]["spin_at_start"] = *s.spin_at_start;
    result["energy"]["spin"] = *s.spin;
  }
  if (s.drag_taken) result["energy"]["taken_by_drag"] = *s.drag_taken;
  for (const EffectEnergy& share : s.by_effect)
    result["energy"]["by_effect"][share.effect][share.what] = share.energy;
  if (s.certified) {
    result["certified"] = {{"verdict", stages_json(s.certified->verdict)},
                           {"time", stages_json(s.certified->time)},
                           {"order", stages_json(s.certified->order)},
                           {"largest_bits", s.certified->largest_bits}};
  }
  if (s.grouping) {
    result["groups"] = {{"dt_restitute", s.dt_restitute},
                        {"largest", s.largest_group},
                        {"oldest", s.oldest_group},
                        {"live", s.live_groups}};
  }
  if (s.observes_clusters) result["clusters"] = clusters_json(s);
  if (!s.final_states.empty()) {
    for (const RunSummary::Final& p : s.final_states) {
      result["final"].push_back(
          {{"id", p.id}, {"species", p.species}, {"position", p.position}, {"velocity", p.velocity}});
    }
  }
  if (s.noise > 0) result["note"] = rounding_note(s);
  if (!s.out_of_range.empty()) result["out_of_range"] = range_message(s);
  if (!s.stalled_on.empty()) result["stalled_on"] = s.stalled_on;
  return json_text(result, 2) + "\n";
}

}  // namespace tps::cli
