#include "reference/scene/random.hpp"

#include <cmath>

#include <Random123/philox.h>

namespace tps {
namespace {

/// True with probability e^-p. REQUIRES 0 <= p <= 1.
/// Von Neumann: uniform numbers that fall, p > u1 > u2 > … , do so at least n times with probability p^n/n!;
/// the number of falls is even with probability 1 - p + p²/2 - … = e^-p.
bool happens_with_exp_minus(double p, RandomStream& stream) {
  bool even = true;
  for (double last = p, u = next_uniform(stream); u < last; last = u, u = next_uniform(stream)) even = !even;
  return even;
}

/// As above, `times` times in a row: true with probability e^-(p·times).
bool happens_with_exp_minus(double p, int times, RandomStream& stream) {
  for (int i = 0; i < times; ++i) {
    if (!happens_with_exp_minus(p, stream)) return false;
  }
  return true;
}

}  // namespace

std::uint64_t draw_bits(std::uint64_t seed, Purpose purpose, std::uint32_t a, std::uint32_t b,
                        std::uint32_t n) {
  const philox4x32_key_t key{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const philox4x32_ctr_t counter{{static_cast<std::uint32_t>(purpose), a, b, n}};
  const philox4x32_ctr_t words = philox4x32_R(10, counter, key);
  return (std::uint64_t{words[1]} << 32) | words[0];
}

double uniform_of_bits(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

double uniform(std::uint64_t seed, Purpose purpose, std::uint32_t a, std::uint32_t b, std::uint32_t n) {
  return uniform_of_bits(draw_bits(seed, purpose, a, b, n));
}

double next_uniform(RandomStream& stream) {
  return uniform(stream.seed, stream.purpose, stream.a, stream.b, stream.n++);
}

double next_normal(RandomStream& stream) {
  // |normal| = k + x with density ∝ e^-(k+x)²/2 = e^(-k/2) · e^(-k(k-1)/2) · e^(-x(2k+x)/2), a factor a step.
  while (true) {
    int k = 0;
    while (happens_with_exp_minus(0.5, stream)) ++k;
    if (!happens_with_exp_minus(0.5, k * (k - 1), stream)) continue;
    const double x = next_uniform(stream);
    const double part = x * (2 * k + x) / (2 * k + 2);  // below 1; k + 1 of them make x(2k+x)/2
    if (!happens_with_exp_minus(part, k + 1, stream)) continue;
    return next_uniform(stream) < 0.5 ? -(k + x) : k + x;
  }
}

double next_exponential(RandomStream& stream) {
  // A run of falling numbers that begins at x has an odd length with probability e^-x.
  for (int whole = 0;; ++whole) {
    const double first = next_uniform(stream);
    bool is_odd = true;
    double last = first;
    for (double next = next_uniform(stream); next < last; next = next_uniform(stream)) {
      last = next;
      is_odd = !is_odd;
    }
    if (is_odd) return whole + first;
  }
}

double next_gamma(RandomStream& stream, double shape) {
  if (shape < 1) {
    const double larger = next_gamma(stream, shape + 1);
    return larger * std::pow(1 - next_uniform(stream), 1 / shape);
  }
  const double d = shape - 1. / 3;
  const double c = 1 / std::sqrt(9 * d);
  while (true) {
    const double x = next_normal(stream);
    const double root = 1 + c * x;
    if (root <= 0) continue;
    const double v = root * root * root;
    const double u = 1 - next_uniform(stream);
    if (u < 1 - 0.0331 * x * x * x * x) return d * v;
    if (std::log(u) < x * x / 2 + d * (1 - v + std::log(v))) return d * v;
  }
}

}  // namespace tps
