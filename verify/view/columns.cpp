#include "verify/view/columns.hpp"

#include <bit>
#include <cstring>
#include <type_traits>

namespace tps::view {
namespace {

static_assert(std::endian::native == std::endian::little, "columns are copied as they lie in memory");

template <typename Number>
void append(std::string& bytes, Number x) {
  char raw[sizeof x];
  std::memcpy(raw, &x, sizeof x);
  bytes.append(raw, sizeof x);
}

template <typename Number>
constexpr std::string_view kType = std::is_same_v<Number, double> ? "f64"
                                   : sizeof(Number) == 4          ? "i32"
                                                                  : "u8";

/// What an event has besides its numbers: bits of "event_flags".
std::uint8_t flags(const Event& e) {
  return static_cast<std::uint8_t>((e.has_dp ? 1U : 0U) | (e.formed ? 2U : 0U) | (e.broken ? 4U : 0U) |
                                   (e.load ? 8U : 0U));
}

}  // namespace

void Columns::start(std::string_view name, std::string_view type, std::size_t length) {
  bytes_.resize((bytes_.size() + 7) / 8 * 8);
  places_[std::string(name)] = {{"type", type}, {"from", bytes_.size()}, {"length", length}};
}

template <typename Number, typename Rows, typename Of>
void Columns::column(std::string_view name, const Rows& rows, Of of) {
  start(name, kType<Number>, rows.size());
  for (const auto& row : rows) append(bytes_, static_cast<Number>(of(row)));
}

template <typename Rows, typename Of>
void Columns::vectors(std::string_view name, const Rows& rows, Of of, int dimension) {
  start(name, kType<double>, rows.size() * static_cast<std::size_t>(dimension));
  for (const auto& row : rows) {
    const Coordinates& v = of(row);
    for (int k = 0; k < dimension; ++k) append(bytes_, v[static_cast<std::size_t>(k)]);
  }
}

Columns::Columns(const Playback& p) {
  const int dimension = p.scene.dimension;
  using Row = const Particle&;
  column<std::int32_t>("particle_id", p.scene.particles, [](Row r) { return r.id; });
  column<std::int32_t>("particle_species", p.scene.particles, [](Row r) { return r.species; });
  vectors(
      "particle_position", p.scene.particles, [](Row r) -> const auto& { return r.position; }, dimension);
  vectors(
      "particle_velocity", p.scene.particles, [](Row r) -> const auto& { return r.velocity; }, dimension);

  column<double>("event_t", p.events, [](const Event& e) { return e.t; });
  column<double>("event_dt", p.events, [](const Event& e) { return e.dt; });
  column<double>("event_k", p.events, [](const Event& e) { return e.k; });
  column<double>("event_line", p.events, [](const Event& e) { return e.line; });
  column<std::uint8_t>("event_kind", p.events, [](const Event& e) { return e.kind; });
  column<std::uint8_t>("event_flags", p.events, flags);
  column<std::int32_t>("event_i", p.events, [](const Event& e) { return e.i; });
  column<std::int32_t>("event_j", p.events, [](const Event& e) { return e.j; });
  column<std::int32_t>("event_first_change", p.events, [](const Event& e) { return e.first_change; });
  vectors(
      "event_dp", p.events, [](const Event& e) -> const auto& { return e.dp; }, dimension);

  column<double>("change_t", p.changes, [](const Change& c) { return c.t; });
  column<std::int32_t>("change_particle", p.changes, [](const Change& c) { return c.particle; });
  column<std::int32_t>("change_body", p.changes, [](const Change& c) { return c.body; });
  vectors(
      "change_position", p.changes, [](const Change& c) -> const auto& { return c.position; }, dimension);
  vectors(
      "change_velocity", p.changes, [](const Change& c) -> const auto& { return c.velocity; }, dimension);

  column<double>("tether_t", p.tethers, [](const TetherChange& c) { return c.t; });
  column<std::int32_t>("tether_i", p.tethers, [](const TetherChange& c) { return c.i; });
  column<std::int32_t>("tether_j", p.tethers, [](const TetherChange& c) { return c.j; });
  column<std::uint8_t>("tether_formed", p.tethers, [](const TetherChange& c) { return c.formed; });
}

}  // namespace tps::view
