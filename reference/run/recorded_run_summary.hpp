// What a RecordedRun says when it has ended. Included by run_in.hpp, behind the class.
#pragma once

namespace tps {

template <typename Scalar, int D>
RunSummary RecordedRun<Scalar, D>::summarise(EndReason reason, const Time<Scalar>& end,
                                             double seconds) const {
  RunSummary s;
  s.title = scene_.title;
  s.scalar = scalar_names()[static_cast<std::size_t>(options_.scalar)];
  s.end = name(reason);
  s.t = static_cast<double>(end.hi);
  s.exact_t = time_of_end(reason, end);
  if (scene_.drag)
    s.t = reason == EndReason::duration ? duration_ : drag_time(scene_.drag->gamma, whole(end), 0);
  s.particles = world().particles.size();
  s.events = world().events;
  s.events_here = world().events - first_event_;
  s.by_kind = {world().statistics.by_kind.begin(), world().statistics.by_kind.end()};
  s.seconds = seconds;
  if (options_.timing == Timing::certified) s.certified = options_.certifier->counters();
  summarise_conservation(s);
  summarise_drag(s, end);
  summarise_effects(s, end);
  s.worst_inner_excess = static_cast<double>(world().statistics.worst_inner_excess);
  s.worst_outer_excess = static_cast<double>(world().statistics.worst_outer_excess);
  const BoundExcess<Scalar> audit = audit_bounds(world(), end);
  s.audit_inner_excess = static_cast<double>(audit.inner);
  s.audit_outer_excess = static_cast<double>(audit.outer);
  s.observes_clusters = scene_.clusters.has_value();
  if (scene_.clusters) s.cluster_species = scene_.species[world().index(scene_.clusters->species)].name;
  s.clusters = samples_;
  if (scene_.clusters && (samples_.empty() || samples_.back().t < s.t)) {
    s.clusters.push_back(sample_clusters(world(), ClusterMoment{s.t, false, "end", {}}));
  }
  summarise_groups(s, end);
  s.noise = world().statistics.noise;
  s.first_noise = world().statistics.first_noise;
  s.zero_impulse = world().statistics.zero_impulse;
  if (s.particles <= RunSummary::kFewParticles) s.final_states = final_states(end);
  s.out_of_range = out_of_range_;
  if (reason == EndReason::stalled) s.stalled_on = stalled_particles();
  return s;
}

template <typename Scalar, int D>
void RecordedRun<Scalar, D>::summarise_conservation(RunSummary& s) const {
  using std::sqrt;
  const Ledger<Scalar, D>& ledger = world().ledger;
  Vector<Scalar, D> drift = momentum(world()) - ledger.momentum_at_start;
  for (int k = 0; k < D; ++k) {
    const std::size_t n = static_cast<std::size_t>(k);
    drift[k] -= ledger.from_walls[n].value() + ledger.from_outside[n].value();
  }
  s.momentum_drift = static_cast<double>(norm<Scalar, D>(drift));
  const Scalar kinetic = kinetic_energy(world());
  const Scalar gained = kinetic - ledger.kinetic_at_start;
  const Scalar remainder = gained + ledger.stored.value() + ledger.lost.value() - ledger.work.value();
  s.kinetic_at_start = static_cast<double>(ledger.kinetic_at_start);
  s.kinetic = static_cast<double>(kinetic);
  s.stored = static_cast<double>(ledger.stored.value());
  s.lost = static_cast<double>(ledger.lost.value());
  s.work = static_cast<double>(ledger.work.value());
  s.energy_remainder = static_cast<double>(remainder);
  Scalar energy_bound = ledger.energy_bound;
  if (const auto spin = world().coupling->spin_energies(world())) {
    s.spin_at_start = static_cast<double>(spin->at_start);
    s.spin = static_cast<double>(spin->now);
    s.energy_remainder = static_cast<double>(Scalar(remainder + (spin->now - spin->at_start)));
    const Scalar share = Scalar(4) * std::numeric_limits<Scalar>::epsilon();  // 8 u
    energy_bound += share * spin->now + share * spin->at_start + bound_of_underflow<Scalar>(s.particles);
  }
  const BoundOfSums<Scalar> sums = bound_of_sums(world(), kinetic);
  s.momentum_bound = static_cast<double>(Scalar(ledger.momentum_bound + sums.momentum));
  s.energy_bound = static_cast<double>(Scalar(energy_bound + sums.energy));
}

/// From the run's energies and momenta to those of the scene: times (1 − γs)², times 1 − γs. The bounds are
/// those of docs/ledger.md, "With drag".
template <typename Scalar, int D>
void RecordedRun<Scalar, D>::summarise_drag(RunSummary& s, const Time<Scalar>& end) const {
  if (!scene_.drag) return;
  const Coupling<Scalar, D>& coupling = *world().coupling;
  const Scalar f = coupling.velocity_unit(end);
  const Scalar lost = coupling.lost(world());
  const Scalar taken = coupling.taken(world(), end);
  const Scalar kinetic = kinetic_energy(world()) * f * f;
  const Scalar at_start = world().ledger.kinetic_at_start;
  const Scalar remainder = (kinetic - at_start) + lost + taken;
  const double f_end = static_cast<double>(f);
  s.drag_taken = static_cast<double>(taken);
  s.kinetic = static_cast<double>(kinetic);
  s.lost = static_cast<double>(lost);
  s.energy_remainder = static_cast<double>(remainder);
  using Limits = std::numeric_limits<Scalar>;
  const Scalar underflow = Scalar(4) * (Scalar(world().events) + Scalar(2)) * Limits::denorm_min();
  const Scalar own = Scalar(16) * Limits::epsilon() * at_start + underflow;  // 32 u
  s.energy_bound = f_end * f_end * s.energy_bound + static_cast<double>(own);
  s.momentum_drift *= f_end;
  s.momentum_bound *= f_end;
}

/// Impulses at given times have what work the others leave, rebounds and tethers what loss.
template <typename Scalar, int D>
void RecordedRun<Scalar, D>::summarise_effects(RunSummary& s, const Time<Scalar>& end) const {
  Scalar work = world().ledger.work.value();
  Scalar lost = world().coupling->lost(world());
  std::set<std::string_view> called;
  for (const auto& effect : simulation_->effects()) {
    called.insert(effect->name());
    for (const auto& [what, energy] : effect->energies(world(), end)) {
      s.by_effect.push_back({std::string(effect->name()), std::string(what), static_cast<double>(energy)});
      if (what == "work" || what == "heat") work -= energy;
      if (what == "lost") lost -= energy;
    }
  }
  const auto rest = [&](std::string_view effect, const char* what, const Scalar& energy) {
    if (called.contains(effect))
      s.by_effect.push_back({std::string(effect), what, static_cast<double>(energy)});
  };
  rest("scheduled_impulses", "work", work);
  rest("grouping", "stored", world().ledger.stored.value());
  rest(called.contains("rebound") ? "rebound" : "tethering", "lost", lost);
  if (called.contains("rebound") && called.contains("tethering"))
    s.by_effect.back().effect += " and tethering";
}

template <typename Scalar, int D>
void RecordedRun<Scalar, D>::summarise_groups(RunSummary& s, const Time<Scalar>& end) const {
  if (!scene_.grouping) return;
  s.grouping = true;
  s.dt_restitute = scene_.grouping->dt_restitute;
  s.largest_group = world().statistics.largest_group;
  const LiveGroups<Scalar> live = world().coupling->live_groups(end);
  s.live_groups = live.count;
  s.oldest_group = static_cast<double>(std::max(world().statistics.oldest_group, live.oldest));
}

template <typename Scalar, int D>
std::vector<RunSummary::Final> RecordedRun<Scalar, D>::final_states(const Time<Scalar>& end) const {
  const auto decimal = [](const Scalar& x) {
    std::ostringstream text;
    text.precision(std::numeric_limits<Scalar>::digits10);
    text << x;
    return text.str();
  };
  const Scalar unit = world().coupling->velocity_unit(end);
  std::vector<RunSummary::Final> states;
  for (int i = 0; i < world().size(); ++i) {
    const Vector<Scalar, D> position = world().position(i, end);
    RunSummary::Final state{scene_.particles[world().index(i)].id,
                            scene_.species[world().index(world().species(i))].name,
                            {},
                            {}};
    for (int k = 0; k < D; ++k) {
      state.position.push_back(decimal(position[k]));
      state.velocity.push_back(decimal(Scalar(world().velocity(i)[k] * unit)));
    }
    states.push_back(state);
  }
  return states;
}

template <typename Scalar, int D>
std::vector<std::string> RecordedRun<Scalar, D>::stalled_particles() const {
  std::vector<std::string> names;
  for (const int i : std::set<int>(last_involved_.begin(), last_involved_.end())) {
    if (i < 0) continue;
    names.push_back(std::to_string(scene_.particles[world().index(i)].id) + " (" +
                    scene_.species[world().index(world().species(i))].name + ")");
  }
  return names;
}

}  // namespace tps
