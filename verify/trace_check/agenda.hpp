// When each of the many partners of one particle has next to be asked about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

namespace tps::check {

/// The partners of a particle that never begins another flight (a membrane): each is asked when it has begun
/// one since it was last asked, and when the time has come until which nothing can be wrong with it. So an
/// event of the particle costs those few, however many partners it has (docs/check.md, "Neighbours").
class Agenda {
 public:
  /// Nothing is known of any of them at first. `particles`: how many there are in the scene.
  Agenda(const std::vector<int>& partners, std::size_t particles);

  /// A particle began another flight. Of one that is no partner nothing happens.
  void begins_flight(int i);

  struct Due {
    int partner;
    bool roughly;  ///< put off until no more than about when it has to be asked
  };
  /// Takes out, in ascending order, whoever has to be asked at t. Holds until it is asked again.
  const std::vector<Due>& due(double t);
  /// Puts one that was due back: it is due again at any time from t on.
  void put_off(int partner, double t, bool roughly = false);

 private:
  enum class Place : std::uint8_t { no_partner, open, waiting, out };
  struct Waiting {
    double t;
    int partner;
    std::uint32_t number;
    bool roughly;
    bool operator>(const Waiting& other) const { return t > other.t; }
  };

  std::vector<Place> place_;           ///< by particle
  std::vector<std::uint32_t> number_;  ///< of times that a particle was put off: older ones are void
  std::vector<Due> due_;
  std::vector<int> open_;  ///< due whatever the time
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting_;
};

}  // namespace tps::check
