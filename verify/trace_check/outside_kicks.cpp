#include "verify/trace_check/outside_kicks.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace tps::check {

OutsideKicks::OutsideKicks(const Scene& scene) : scheduled_(scene.impulses), gravity_(scene.gravity) {
  std::stable_sort(scheduled_.begin(), scheduled_.end(),
                   [](const ScheduledImpulse& a, const ScheduledImpulse& b) {
                     return std::tie(a.at, a.particle) < std::tie(b.at, b.particle);
                   });
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Species& species = scene.species[static_cast<std::size_t>(scene.particles[i].species)];
    const int particle = static_cast<int>(i);
    if (species.random_impulses)
      add_random(scene, Kind::random_impulse, Purpose::random_impulse_wait, particle,
                 species.random_impulses->tau);
    if (species.thermostat)
      add_random(scene, Kind::thermostat, Purpose::thermostat_wait, particle, species.thermostat->tau);
  }
}

void OutsideKicks::add_random(const Scene& scene, Kind kind, Purpose wait, int particle, double tau) {
  const std::int32_t id = scene.particles[static_cast<std::size_t>(particle)].id;
  const PoissonTimes times(scene.seed, wait, id, tau);
  random_[kind].times.emplace(particle, times);
  random_[kind].waiting.emplace(times.next(), particle);
}

std::optional<OutsideKick> OutsideKicks::next(Kind kind) const {
  if (kind == Kind::scheduled_impulse) {
    if (scheduled_done_ == scheduled_.size()) return std::nullopt;
    return OutsideKick{scheduled().at, scheduled().particle};
  }
  if (kind == Kind::gravity) {
    if (!gravity_) return std::nullopt;
    return OutsideKick{static_cast<double>(gravity_done_) * gravity_->every, -1};
  }
  const auto found = random_.find(kind);
  if (found == random_.end()) return std::nullopt;
  const auto [at, particle] = *found->second.waiting.begin();
  return OutsideKick{at, particle, found->second.times.at(particle).done() + 1};
}

void OutsideKicks::take(Kind kind) {
  if (kind == Kind::scheduled_impulse) {
    ++scheduled_done_;
    return;
  }
  if (kind == Kind::gravity) {
    ++gravity_done_;
    return;
  }
  Random& random = random_.at(kind);
  ++random.taken;
  const int particle = random.waiting.begin()->second;
  random.waiting.erase(random.waiting.begin());
  PoissonTimes& times = random.times.at(particle);
  times.advance();
  random.waiting.emplace(times.next(), particle);
}

void OutsideKicks::pass_over(Kind kind, std::uint64_t count) {
  if (kind == Kind::gravity) {
    if (count > 0 && !gravity_) throw std::out_of_range("the scene has no gravity");
    gravity_done_ += count;
    return;
  }
  for (std::uint64_t n = 0; n < count; ++n) {
    if (!next(kind)) throw std::out_of_range("the scene has fewer impulses");
    take(kind);
  }
}

std::uint64_t OutsideKicks::taken(Kind kind) const {
  if (kind == Kind::scheduled_impulse) return scheduled_done_;
  if (kind == Kind::gravity) return gravity_done_;
  const auto found = random_.find(kind);
  return found == random_.end() ? 0 : found->second.taken;
}

}  // namespace tps::check
