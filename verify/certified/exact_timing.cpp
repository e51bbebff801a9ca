#include "verify/certified/exact_timing.hpp"

#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"

namespace tps::certified {

CollisionTime<double> ExactTiming::answer(const TimingQuery& query) {
  return exact::rounded_time(query, counters_);
}

std::weak_ordering ExactTiming::order(const Moment& first, const Moment& second) {
  switch (exact::moment_order(first, second, counters_)) {
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

}  // namespace tps::certified
