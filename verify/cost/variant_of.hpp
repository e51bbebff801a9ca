// Makes a variant of a function: its answer without rounding, and the two loops that are timed.
#pragma once

#include <bit>
#include <cmath>

#include "reference/equations/timing_verdict.hpp"
#include "verify/cost/variant.hpp"

namespace tps::cost {

/// Keeps the compiler from leaving out what nobody reads.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "m"(value) : "memory");
}

/// Zero, which the compiler cannot know.
inline std::uint64_t opaque_zero() {
  std::uint64_t zero = 0;
  asm volatile("" : "+r"(zero));
  return zero;
}

template <typename Scalar>
ExactNumber exact_number(const Scalar& x) {
  using std::frexp;
  ExactNumber number;
  Scalar rest = frexp(x, &number.exponent);
  for (double& part : number.parts) {
    part = static_cast<double>(rest);
    rest -= Scalar(part);
  }
  return number;
}

template <typename Scalar>
bool is_number(const Scalar& t) {
  using std::abs;
  return abs(t) <= (std::numeric_limits<Scalar>::max)();  // false for NaN
}

template <typename Scalar>
Answer answer_of(const std::optional<Scalar>& t) {
  if (!t || *t != *t) return {};
  if (*t == Scalar(0)) return {true, std::nullopt, true, std::nullopt};
  if (!is_number(*t)) return {true, std::nullopt, false, std::nullopt};
  return {true, exact_number(*t), false, std::nullopt};
}

template <typename Scalar>
Answer answer_of(const CollisionTime<Scalar>& answer) {
  Answer result = answer_of(answer.t);
  result.verdict = answer.verdict;
  return result;
}

inline Answer answer_of(TimingVerdict verdict) {
  return {occurs(verdict), std::nullopt, at_once(verdict), verdict};
}

template <typename Scalar>
std::uint64_t bits_of_answer(const std::optional<Scalar>& t) {
  return t ? std::bit_cast<std::uint64_t>(static_cast<double>(*t)) : 0;
}

template <typename Scalar>
std::uint64_t bits_of_answer(const CollisionTime<Scalar>& answer) {
  return bits_of_answer(answer.t) + static_cast<std::uint64_t>(answer.verdict);
}

inline std::uint64_t bits_of_answer(TimingVerdict verdict) {
  return static_cast<std::uint64_t>(verdict);
}

template <auto ask>
void throughput(std::span<const TimingQuery> queries) {
  for (const TimingQuery& query : queries) {
    const auto answer = ask(query);
    keep(answer);
  }
}

template <auto ask>
void latency(std::span<const TimingQuery> queries) {
  const std::uint64_t zero = opaque_zero();
  std::uint64_t carried = 0;
  TimingQuery asked{};
  for (const TimingQuery& query : queries) {
    asked = query;
    asked.L = std::bit_cast<double>(std::bit_cast<std::uint64_t>(query.L) ^ carried);
    carried = bits_of_answer(ask(asked)) & zero;
  }
  keep(carried);
}

/// A variant of `ask`: a function of a query that gives a CollisionTime, an optional time, or a verdict.
template <auto ask>
Variant variant_of(const std::string& formula, const std::string& arithmetic, int bits) {
  using Result = decltype(ask(std::declval<const TimingQuery&>()));
  const std::string name = arithmetic.empty() ? formula : formula + "-" + arithmetic;
  return {name,
          formula,
          arithmetic,
          bits,
          !std::is_same_v<Result, TimingVerdict>,
          [](const TimingQuery& query) { return answer_of(ask(query)); },
          throughput<ask>,
          latency<ask>};
}

}  // namespace tps::cost
