// A periodic box: whom of a particle's images another one passes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "verify/trace_check/pair_flight.hpp"

namespace tps::check {

/// Edges that a flight may cross before its images are too many to be judged: the time it takes is theirs.
constexpr double kMostCrossings = 1e4;
constexpr const char* kTooManyImages =
    "images in a periodic box on flights that cross more than 10000 of its edges before the next event";

/// The images of j that i can have come near to within `reach` during a flight; nothing else than j itself
/// without a periodic box, none where the flight crosses more than kMostCrossings edges. The flight is looked
/// at in pieces that go no further than an edge along any axis, each axis for itself, so that their number
/// grows with the edges that are crossed and not with the product of the axes.
template <typename Number>
std::optional<std::vector<Vec<Number>>> images_on_the_way(const Model<Number>& model, int i, int j,
                                                          const Work<Number>& dt, const Work<Number>& reach) {
  using std::abs;
  using std::ceil;
  using std::floor;
  using W = Work<Number>;
  if (!model.edges) return std::vector<Vec<Number>>{Vec<Number>{}};
  const PairFlight<Number> pair = pair_flight(model, i, j);
  const RelativeFlight<W> flight = pair.relative();
  const auto edge = [&](std::size_t k) { return W((*model.edges)[k]); };
  W pieces(1);
  for (std::size_t k = 0; k < 3; ++k) {
    if (edge(k) != W(0)) pieces = std::max(pieces, W(ceil(W(abs(W(dt * flight.v[k])) / edge(k)))));
  }
  if (!(pieces <= W(kMostCrossings))) return std::nullopt;

  using Place = std::array<double, 3>;  // z, y, x: whole numbers of edges
  std::vector<Place> places;
  for (W piece(0); piece < pieces; piece += W(1)) {
    std::vector<Place> near{Place{}};
    for (std::size_t k = 0; k < 3; ++k) {
      if (edge(k) == W(0)) continue;
      const W from = flight.r[k] + dt * (piece / pieces) * flight.v[k];
      const W to = flight.r[k] + dt * ((piece + W(1)) / pieces) * flight.v[k];
      const W wide = reach + edge(k) / W(64);  // for rounding of places
      const W first = ceil(W((-wide - std::max(from, to)) / edge(k)));
      const W last = floor(W((wide - std::min(from, to)) / edge(k)));
      std::vector<Place> more;
      for (W n = first; n <= last; n += W(1)) {
        for (Place place : near) {
          place[2 - k] = static_cast<double>(n);
          more.push_back(place);
        }
      }
      near = std::move(more);
    }
    places.insert(places.end(), near.begin(), near.end());
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::vector<Vec<Number>> images;
  for (const Place& place : places)
    images.push_back({{Number(place[2]), Number(place[1]), Number(place[0])}});
  return images;
}

}  // namespace tps::check
