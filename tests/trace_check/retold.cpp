#include "tests/trace_check/retold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/text/hexfloat.hpp"

namespace tps::mutation {
namespace {

Vec of_dimension(const Coordinates& coordinates, int dimension) {
  return Vec(coordinates.data(), static_cast<std::size_t>(dimension));
}

}  // namespace

Retold::Retold(const Trace& trace) : scene_(&trace.scene) {
  const std::string start = to_hex(scene_->start_time);
  for (const Particle& p : scene_->particles) {
    particles_[p.id] = &p;
    flights_[p.id] = {of_dimension(p.position, scene_->dimension),
                      of_dimension(p.velocity, scene_->dimension), start};
  }
  for (const Tether& t : scene_->tethers) {
    tethers_.insert(std::minmax(scene_->particles[static_cast<std::size_t>(t.i)].id,
                                scene_->particles[static_cast<std::size_t>(t.j)].id));
  }
}

void Retold::hear(const Json& line, std::size_t number) {
  if (!is_event(line)) return;
  const std::string kind = line.at("kind");
  if (kind == "phase_begin") phases_.insert(line.at("phase").get<std::size_t>());
  if (kind == "phase_end") phases_.erase(line.at("phase").get<std::size_t>());
  if (is_load(line)) load_bodies(line, number);
  if (line.value("tether", "") == "formed")
    tethers_.emplace(line.at("i").get<int>(), line.at("j").get<int>());
  if (line.value("tether", "") == "broken")
    tethers_.erase({line.at("i").get<int>(), line.at("j").get<int>()});
  if (!line.contains("post")) return;
  for (const auto& [id, state] : line.at("post").items()) {
    flights_[std::stoi(id)] = {numbers(state.at("position")), numbers(state.at("velocity")), line.at("t")};
  }
  if (kind == "restitute") part_bodies(line);
}

void Retold::load_bodies(const Json& event, std::size_t number) {
  Load made;
  made.i = event.at("i");
  made.j = event.at("j");
  const int pair[2] = {made.i, made.j};
  for (int side = 0; side < 2; ++side) {
    made.mass[side] = body_mass(pair[side]);
    made.sides[side] = load(pair[side]);
    if (!fixed(pair[side])) made.members[side] = body(pair[side]);
  }
  made.line = number;
  const auto shared = std::make_shared<const Load>(made);
  for (const auto& members : shared->members) {
    for (const int id : members) loads_[id] = shared;
  }
}

void Retold::part_bodies(const Json& event) {
  const int i = event.at("i");
  const std::shared_ptr<const Load> ended = load(fixed(i) ? event.at("j").get<int>() : i);
  if (!ended) return;
  for (int side = 0; side < 2; ++side) {
    const Vec velocity = flight(side == 0 ? ended->i : ended->j).velocity;
    for (const int id : ended->members[side]) {
      flights_[id] = {position(id, event.at("t")), velocity, event.at("t")};
      loads_[id] = ended->sides[side];
    }
  }
}

Vec Retold::position(int id, const Json& t) const {
  const Flight& from = flight(id);
  return from.position + from.velocity * elapsed(from.t, t);
}

int Retold::tethers_of(int id) const {
  return static_cast<int>(std::count_if(tethers_.begin(), tethers_.end(), [id](const auto& pair) {
    return pair.first == id || pair.second == id;
  }));
}

const Species& Retold::species(int id) const {
  return scene_->species[static_cast<std::size_t>(particles_.at(id)->species)];
}

const PairLaw* Retold::law(int i, int j) const {
  const auto [a, b] = std::minmax(particles_.at(i)->species, particles_.at(j)->species);
  for (const PairLaw& law : scene_->pairs) {
    if (law.species_a == a && law.species_b == b) return &law;
  }
  return nullptr;
}

const Phase* Retold::phase(int i, int j, bool forming) const {
  const auto [a, b] = std::minmax(particles_.at(i)->species, particles_.at(j)->species);
  for (const std::size_t n : phases_) {
    const Phase& p = scene_->phases[n];
    if (p.species_a == a && p.species_b == b && (forming ? p.form.has_value() : p.breaks.has_value()))
      return &p;
  }
  return nullptr;
}

FormRule Retold::form_rule(int i, int j) const {
  const Phase* now = phase(i, j, true);
  return now != nullptr ? *now->form : law(i, j)->tethering->form;
}

BreakRule Retold::break_rule(int i, int j) const {
  const Phase* now = phase(i, j, false);
  return now != nullptr ? *now->breaks : law(i, j)->tethering->breaks;
}

bool Retold::is_permanent(int i, int j) const {
  const PairLaw* of_pair = law(i, j);
  return of_pair != nullptr && of_pair->tethering &&
         of_pair->tethering->form.when == FormRule::When::permanent;
}

double Retold::mass(int id) const {
  return species(id).mass;
}

bool Retold::fixed(int id) const {
  return mass(id) == std::numeric_limits<double>::infinity();
}

std::shared_ptr<const Load> Retold::load(int id) const {
  const auto found = loads_.find(id);
  return found == loads_.end() ? nullptr : found->second;
}

double Retold::body_mass(int id) const {
  const auto made = load(id);
  return made ? made->mass[0] + made->mass[1] : mass(id);
}

std::vector<int> Retold::body(int id) const {
  const auto made = load(id);
  if (!made) return {id};
  std::vector<int> all;
  std::merge(made->members[0].begin(), made->members[0].end(), made->members[1].begin(),
             made->members[1].end(), std::back_inserter(all));
  return all;
}

double Place::since_previous() const {
  return previous != nullptr ? elapsed(previous->at("t"), event.at("t")) : since_start(trace, event.at("t"));
}

double Place::until_next() const {
  return next != nullptr ? elapsed(event.at("t"), next->at("t")) : std::numeric_limits<double>::infinity();
}

Vec Place::axis() const {
  const Vec r = pre(j(), "position") - pre(i(), "position");
  return r / length(r);
}

bool Place::visible(double distance) const {
  constexpr double kFar = 4096;
  const double size = std::max(length(pre(i(), "position")), length(pre(j(), "position")));
  return std::abs(distance) > kFar * epsilon(trace) * std::max(size, 1.);
}

std::size_t chosen(std::size_t candidates, std::uint64_t number) {
  // The golden ratio spreads successive numbers; 0 is the middle.
  const double place = 0.5 + 0.6180339887498949 * static_cast<double>(number);
  return static_cast<std::size_t>((place - std::floor(place)) * static_cast<double>(candidates));
}

Place place_at(const Trace& trace, const std::vector<std::size_t>& events, std::size_t n,
               const Retold& before) {
  const bool is_last = n + 1 == events.size();
  return {trace,
          before,
          trace.lines[events[n]],
          n == 0 ? nullptr : &trace.lines[events[n - 1]],
          is_last ? nullptr : &trace.lines[events[n + 1]],
          events[n],
          is_last ? 0 : events[n + 1]};
}

Place place_of(const Trace& trace, const Found& found) {
  const std::vector<std::size_t> events = event_lines(trace);
  const auto at = std::lower_bound(events.begin(), events.end(), found.line);
  return place_at(trace, events, static_cast<std::size_t>(at - events.begin()), found.before);
}

}  // namespace tps::mutation
