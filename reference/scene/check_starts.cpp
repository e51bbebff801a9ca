#include "reference/scene/check_starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

#include "reference/scene/point_tree.hpp"
#include "reference/text/number_text.hpp"

namespace tps {
namespace {

using Rational = boost::multiprecision::cpp_rational;

double largest_coordinate(const Coordinates& a, const Coordinates& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max({largest, std::fabs(a[k]), std::fabs(b[k])});
  }
  return largest;
}

double ulp(double value) {
  if (value == 0) return std::numeric_limits<double>::denorm_min();
  int exponent = 0;
  std::frexp(value, &exponent);  // value = f 2^exponent, f in [1/2, 1)
  return std::ldexp(1.0, std::max(exponent - 53, -1074));
}

/// Of b displaced by so many edges along each axis; `edges` are finite where there are any.
StartVerdict exact_verdict(const Coordinates& a, const Coordinates& b, double limit,
                           const std::array<int, 3>& image = {}, const Coordinates& edges = {}) {
  Rational square = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    Rational r = Rational(b[k]) - Rational(a[k]);
    if (image[k] != 0) r += image[k] * Rational(edges[k]);
    square += r * r;
  }
  const Rational allowance(start_allowance(a, b));
  const Rational least = Rational(limit) - allowance;
  const Rational most = Rational(limit) + allowance;
  if (least > 0 && square < least * least) return StartVerdict::nearer;
  return square > most * most ? StartVerdict::farther : StartVerdict::contact;
}

// Squares below this may have lost bits to underflow.
constexpr double safe_square = 0x1p-900;
// A computed difference, square, sum or shifted limit is within 2^-53 of itself of the true one, unless it
// underflows. The squared distance collects four such errors (the difference counts twice), the squared limit
// three: together less than 2^-50, so that a gap of 2^-48 between the two is real.
constexpr double rounding = 0x1p-48;

// What a start is measured against.
struct Limit {
  std::string_view name;
  StartVerdict violation;
  double distance;
};

class Starts {
 public:
  Starts(const Scene& scene, SceneSource& source) : scene_(scene), source_(source) {
    members_.resize(scene.species.size());
    for (const PairLaw& law : scene.pairs) laws_.emplace(std::pair(law.species_a, law.species_b), &law);
    for (std::size_t k = 0; k < scene.particles.size(); ++k) {
      members_[static_cast<std::size_t>(scene.particles[k].species)].push_back(k);
    }
  }

  void check() {
    for (const PairLaw& law : scene_.pairs) {
      if (fixed(law.species_a) && fixed(law.species_b)) continue;
      if (law.blocking) check_blocking(law);
      if (law.tethering && law.tethering->form.when == FormRule::When::permanent) check_permanent(law);
    }
    for (const Tether& tether : scene_.tethers) check_listed(tether);
  }

 private:
  bool fixed(int species) const { return std::isinf(scene_.species[static_cast<std::size_t>(species)].mass); }
  const std::vector<std::size_t>& members(int species) const {
    return members_[static_cast<std::size_t>(species)];
  }

  // Pairs in the order of their places along the axis on which the particles spread most. Only particles
  // whose boxes come near are looked at (point_tree.hpp): piles of one species cost the other nothing.
  void check_blocking(const PairLaw& law) {
    const bool same = law.species_a == law.species_b;
    std::vector<std::size_t> order = members(law.species_a);
    if (!same) order.insert(order.end(), members(law.species_b).begin(), members(law.species_b).end());
    const std::size_t axis = longest_axis(order);
    const auto along = [&](std::size_t k) { return scene_.particles[k].position[axis]; };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return along(a) != along(b) ? along(a) < along(b) : a < b;
    });
    std::vector<std::size_t> rank(scene_.particles.size());
    for (std::size_t n = 0; n < order.size(); ++n) rank[order[n]] = n;
    const Limit limit{"blocking", StartVerdict::nearer, law.blocking->distance};
    const PointTree of_a(scene_, members(law.species_a));
    const PointTree of_b(scene_, same ? std::vector<std::size_t>() : members(law.species_b));
    std::vector<std::size_t> near;
    for (const std::size_t k : order) {
      const Coordinates& position = scene_.particles[k].position;
      near.clear();
      if (scene_.box) {
        check_images(k, limit, same || scene_.particles[k].species == law.species_b ? of_a : of_b);
        if (source_.full()) return;
      }
      const PointTree& others = same || scene_.particles[k].species == law.species_b ? of_a : of_b;
      others.visit([&](const PointTree::Box& box) { return may_be_nearer(box, position, limit.distance); },
                   [&](std::size_t other) {
                     if (rank[other] > rank[k]) near.push_back(other);
                   });
      std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) { return rank[a] < rank[b]; });
      for (const std::size_t other : near) {
        check_pair(k, other, limit);
        if (source_.full()) return;
      }
    }
  }

  /// In a periodic box the images around it are looked at, too, each pair from its first particle.
  void check_images(std::size_t k, const Limit& limit, const PointTree& others) {
    const Coordinates& position = scene_.particles[k].position;
    for (int n = 0; n < 27; ++n) {
      const std::array<int, 3> turn = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      Coordinates image = position;
      bool is_one = n != 13;  // itself
      for (std::size_t axis = 0; axis < 3; ++axis) {
        is_one = is_one && (turn[axis] == 0 || std::isfinite(scene_.box->edges[axis]));
        if (is_one && turn[axis] != 0) image[axis] += turn[axis] * scene_.box->edges[axis];
      }
      if (!is_one) continue;
      others.visit([&](const PointTree::Box& box) { return may_be_nearer(box, image, limit.distance); },
                   [&](std::size_t other) {
                     if (other > k) check_image(other, k, turn, limit);
                   });
    }
  }

  void check_image(std::size_t a, std::size_t b, const std::array<int, 3>& image, const Limit& limit) {
    const Particle& first = scene_.particles[a];
    const Particle& second = scene_.particles[b];
    if (exact_verdict(first.position, second.position, limit.distance, image, scene_.box->edges) !=
        limit.violation)
      return;
    source_.report(
        fmt::format("/particles/{}/position", source_.particle_entries[std::max(a, b)]),
        fmt::format("particles {} and {} start nearer across an edge of the box than their {} distance "
                    "{} by more than 4 ulp of the largest coordinate; move one of them",
                    std::min(first.id, second.id), std::max(first.id, second.id), limit.name,
                    write_shortest(limit.distance)));
  }

  std::size_t longest_axis(const std::vector<std::size_t>& particles) const {
    std::size_t longest = 0;
    double most = -1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const std::size_t k : particles) {
        low = std::min(low, scene_.particles[k].position[axis]);
        high = std::max(high, scene_.particles[k].position[axis]);
      }
      if (high - low > most) {
        most = high - low;
        longest = axis;
      }
    }
    return longest;
  }

  void check_permanent(const PairLaw& law) {
    const Limit limit{"tethering", StartVerdict::farther, law.tethering->distance};
    const PointTree partners(scene_, members(law.species_b));
    std::vector<std::size_t> far;
    for (const std::size_t i : members(law.species_a)) {
      const Coordinates& position = scene_.particles[i].position;
      far.clear();
      partners.visit([&](const PointTree::Box& box) { return may_be_farther(box, position, limit.distance); },
                     [&](std::size_t j) {
                       if (law.species_a != law.species_b || j > i) far.push_back(j);
                     });
      std::sort(far.begin(), far.end());
      for (const std::size_t j : far) {
        check_pair(i, j, limit);
        if (source_.full()) return;
      }
    }
  }

  void check_listed(const Tether& tether) {
    const auto i = static_cast<std::size_t>(tether.i);
    const auto j = static_cast<std::size_t>(tether.j);
    const auto [a, b] = std::minmax(scene_.particles[i].species, scene_.particles[j].species);
    const auto law = laws_.find({a, b});
    if (law == laws_.end() || !law->second->tethering) return;
    check_pair(i, j, {"tethering", StartVerdict::farther, law->second->tethering->distance});
  }

  /// The image of b that is nearest to a.
  std::array<int, 3> nearest_image(const Particle& a, const Particle& b) const {
    std::array<int, 3> image{};
    if (!scene_.box) return image;
    for (std::size_t k = 0; k < image.size(); ++k) {
      const double edge = scene_.box->edges[k];
      if (std::isfinite(edge))
        image[k] = -static_cast<int>(std::floor((b.position[k] - a.position[k]) / edge + 0.5));
    }
    return image;
  }

  void check_pair(std::size_t i, std::size_t j, const Limit& limit) {
    const Particle& a = scene_.particles[std::min(i, j)];
    const Particle& b = scene_.particles[std::max(i, j)];
    const std::array<int, 3> image = nearest_image(a, b);
    const bool is_at_home = image == std::array<int, 3>{};
    const StartVerdict verdict =
        is_at_home || limit.violation == StartVerdict::nearer
            ? start_verdict(a.position, b.position, limit.distance)
            : exact_verdict(a.position, b.position, limit.distance, image, scene_.box->edges);
    if (verdict != limit.violation) return;
    const double distance = std::hypot(b.position[0] - a.position[0], b.position[1] - a.position[1],
                                       b.position[2] - a.position[2]);
    const bool nearer = limit.violation == StartVerdict::nearer;
    source_.report(
        fmt::format("/particles/{}/position", source_.particle_entries[std::max(i, j)]),
        fmt::format(
            "particles {} and {} start {} apart, {} than their {} distance {} by more than 4 ulp of the "
            "largest coordinate ({}); move one of them",
            a.id, b.id, write_shortest(distance), nearer ? "nearer" : "farther", limit.name,
            write_shortest(limit.distance), write_shortest(start_allowance(a.position, b.position))));
  }

  const Scene& scene_;
  SceneSource& source_;
  std::vector<std::vector<std::size_t>> members_;
  std::map<std::pair<int, int>, const PairLaw*> laws_;
};

}  // namespace

double start_allowance(const Coordinates& a, const Coordinates& b) {
  return 4 * ulp(largest_coordinate(a, b));
}

StartVerdict start_verdict(const Coordinates& a, const Coordinates& b, double limit) {
  double square = 0;
  for (std::size_t k = 0; k < a.size(); ++k) square += (b[k] - a[k]) * (b[k] - a[k]);
  const double allowance = start_allowance(a, b);
  const double most = (limit + allowance) * (limit + allowance) * (1 + rounding);
  if (std::isfinite(square) && square > safe_square && square > most) return StartVerdict::farther;
  const double least = (limit - allowance) * (limit - allowance) * (1 - rounding);
  if (limit > allowance && std::isfinite(least) && least > safe_square && square < least) {
    return StartVerdict::nearer;
  }
  return exact_verdict(a, b, limit);
}

void check_starts(const Scene& scene, SceneSource& source) {
  Starts(scene, source).check();
}

}  // namespace tps
