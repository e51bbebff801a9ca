#include <utility>

#include "verify/certified/ball.hpp"

namespace tps::certified {
namespace {

thread_local WorkingPrecision* innermost = nullptr;

constexpr long kBitsWithoutAChoice = 512;

}  // namespace

WorkingPrecision::WorkingPrecision(long bits) : outer_(std::exchange(innermost, this)), bits_(bits) {}

WorkingPrecision::~WorkingPrecision() {
  innermost = outer_;
}

long WorkingPrecision::bits() {
  return innermost != nullptr ? innermost->bits_ : kBitsWithoutAChoice;
}

void WorkingPrecision::doubt() {
  if (innermost != nullptr) innermost->doubted_ = true;
}

}  // namespace tps::certified
