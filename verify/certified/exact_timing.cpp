#include "verify/certified/exact_timing.hpp"

namespace tps::certified {
namespace {

std::weak_ordering ordering(exact::Order order) {
  switch (order) {
    case exact::Order::before:
      return std::weak_ordering::less;
    case exact::Order::after:
      return std::weak_ordering::greater;
    case exact::Order::equal:
    case exact::Order::none:
      break;
  }
  return std::weak_ordering::equivalent;
}

}  // namespace

CollisionTime<double> ExactTiming::answer(const TimingQuery& query) {
  return exact::rounded_time(query, counters_);
}

std::weak_ordering ExactTiming::order(const Moment& first, const Moment& second) {
  return ordering(exact::moment_order(first, second, counters_));
}
std::weak_ordering ExactTiming::order(const exact::KnownMoment& first, const exact::KnownMoment& second) {
  return ordering(exact::moment_order(first, second, counters_));
}

}  // namespace tps::certified
