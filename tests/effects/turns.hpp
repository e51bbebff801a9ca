// Quarter turns: at given times a short pulse of a strong magnetic field along z turns the velocity of one
// charged particle by a right angle. An effect that the reference does not have, brought along by a program:
// what CONTRIBUTING.md says an effect takes is all that it is.
//
// Laws: (1) speed and kinetic energy stay, bit for bit; (2) a turn to the left and one to the right leave the
// velocity as it was; (3) z is kept.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "reference/engine/brought_effect.hpp"
#include "reference/engine/world.hpp"
#include "reference/scene/scene_values.hpp"
#include "reference/text/number_text.hpp"

namespace tps::effects {

struct Turn {
  double at = 0;
  int particle = 0;     ///< index
  std::int32_t id = 0;  ///< of the particle
  bool left = true;
};

/// "turns" of a scene, in the order (time, id).
class TurnsSection final : public SceneSection {
 public:
  explicit TurnsSection(std::vector<Turn> turns) : turns_(std::move(turns)) {
    std::stable_sort(turns_.begin(), turns_.end(), [](const Turn& a, const Turn& b) {
      return std::pair(a.at, a.particle) < std::pair(b.at, b.particle);
    });
  }
  const std::vector<Turn>& turns() const { return turns_; }

  std::string json() const override {
    std::string text = "[";
    for (const Turn& turn : turns_) {
      text += text.size() > 1 ? "," : "";
      text += "{\"at\":" + write_shortest(turn.at) + ",\"particle\":" + std::to_string(turn.id) +
              ",\"towards\":\"" + (turn.left ? "left" : "right") + "\"}";
    }
    return text + "]";
  }

 private:
  std::vector<Turn> turns_;
};

/// Those of a scene; none without the key.
inline const std::vector<Turn>& turns_of(const Scene& scene) {
  static const std::vector<Turn> none;
  const auto* section = section_of<TurnsSection>(scene, "turns");
  return section == nullptr ? none : section->turns();
}

template <typename Scalar, int D>
class Turns final : public Effect<Scalar, D> {
 public:
  using Vec = Vector<Scalar, D>;

  explicit Turns(const Scene& scene) : turns_(turns_of(scene)), quarters_(scene.particles.size(), 0) {}
  std::string_view name() const override { return "turns"; }

  void begin(World<Scalar, D>&, int self) override { self_ = self; }
  void queue_known(World<Scalar, D>& world) override {
    if (done_ == turns_.size()) return;
    world.queue.push(world.pending({Scalar(turns_[done_].at), Scalar(0)}, kRank, -1, -1, 0, self_));
  }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>&) override {
    const Turn& turn = turns_[done_++];
    const int i = turn.particle;
    Record<Scalar, D> record = world.open_record("turn", i, i);
    const Vec before = world.velocity(i);
    Vec after = before;
    after[0] = turn.left ? Scalar(-before[1]) : before[1];
    after[1] = turn.left ? before[0] : Scalar(-before[0]);
    const Vec change = after - before;
    record.dp = world.mass(i) * change;
    world.ledger.add_from_outside(*record.dp);
    world.set_velocity(i, after);
    world.touch(i);
    std::int64_t& quarters = quarters_[world.index(i)];
    quarters += turn.left ? 1 : -1;
    added_.own = {{"towards", std::string_view(turn.left ? "left" : "right")},
                  {"quarters", quarters},
                  {"change", std::vector<Scalar>(change.begin(), change.end())}};
    record.addition = &added_;
    world.close_record(record);
    queue_known(world);
  }

  std::uint64_t progress() const override { return done_; }
  void resume(World<Scalar, D>&, std::uint64_t progress) override { done_ = progress; }

  /// How often each particle has been turned to the left, less to the right.
  using Numbers = typename Effect<Scalar, D>::Numbers;
  Numbers numbers(const World<Scalar, D>&) const override {
    return {{"turns_quarters", {quarters_.begin(), quarters_.end()}}};
  }
  void take_numbers(World<Scalar, D>&, const Numbers& numbers) override {
    const std::vector<Scalar>& kept = numbers.at("turns_quarters");
    std::transform(kept.begin(), kept.end(), quarters_.begin(),
                   [](const Scalar& x) { return static_cast<std::int64_t>(x); });
  }

 private:
  static constexpr Rank kRank{25};  ///< after impulses at a given time, before gravity

  std::vector<Turn> turns_;
  std::vector<std::int64_t> quarters_;
  Addition<Scalar, D> added_;
  std::size_t done_ = 0;
  int self_ = 0;
};

/// What a scene says under "turns". Throws nothing; reports to the source.
inline std::shared_ptr<const SceneSection> read_turns(const JsonValue& value, const Scene& scene,
                                                      SceneSource& source) {
  std::vector<Turn> turns;
  if (scene.grouping || scene.drag)
    source.report("/turns", "\"turns\" are defined without \"grouping\" and without \"drag\"; remove one");
  for (std::size_t n = 0; n < value.array()->size(); ++n) {
    const JsonValue& entry = (*value.array())[n];
    const std::string at = "/turns/" + std::to_string(n);
    const auto id = integer_of(*entry.find("particle"));
    const auto found = std::find_if(scene.particles.begin(), scene.particles.end(),
                                    [&](const Particle& p) { return p.id == id; });
    if (found == scene.particles.end()) {
      source.report(at + "/particle", "no particle has the id " + std::to_string(id));
      continue;
    }
    if (scene.species[static_cast<std::size_t>(found->species)].mass ==
        std::numeric_limits<double>::infinity())
      source.report(at + "/particle",
                    "particle " + std::to_string(id) + " has infinite mass: nothing turns it");
    turns.push_back({number_at(entry, "at"), static_cast<int>(found - scene.particles.begin()), id,
                     *entry.find("towards")->string() == "left"});
  }
  return std::make_shared<TurnsSection>(std::move(turns));
}

struct turns {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"turns", "velocities turned by a right angle at given times", {}, "\"turns\"", {}};
    if (!turns_of(scene).empty()) call.because.push_back(key_of_scene("turns"));
    call.cost = std::to_string(turns_of(scene).size()) + " events";
    return call;
  }
  static EffectRecords records(const Scene& scene) {
    return {.kinds = {{"turn", About::particle, {"towards", "quarters", "change"}}},
            .known = {{turns_of(scene).size(), "is more than the turns of the scene"}},
            .quantities = {{"turns_quarters", scene.particles.size()}}};
  }
  static SceneKey key() {
    return {"turns", R"({
      "title": "Quarter turns",
      "description": "Each entry turns the velocity of one particle by a right angle about z, at a time of the run.",
      "type": "array",
      "items": {
        "type": "object",
        "required": ["at", "particle", "towards"],
        "additionalProperties": false,
        "properties": {
          "at": {"$ref": "#/$defs/number", "minimum": 0},
          "particle": {"$ref": "#/$defs/particle_id"},
          "towards": {"enum": ["left", "right"]}
        }
      }
    })",
            &read_turns};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene& scene) {
    return std::make_unique<Turns<Scalar, D>>(scene);
  }
};

}  // namespace tps::effects
