// Twins: two questions that differ in the last bit of one number and have different answers.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace tps::vectors {

/// Halves the doubles between two of one sign until two adjacent ones are left that `same_as_first` tells
/// apart. REQUIRES first and last of one sign, same_as_first(first), !same_as_first(last).
template <typename Predicate>
std::pair<double, double> straddling_doubles(double first, double last, Predicate same_as_first) {
  const double sign = std::signbit(first) ? -1 : 1;
  auto near = std::bit_cast<std::uint64_t>(std::fabs(first));
  auto far = std::bit_cast<std::uint64_t>(std::fabs(last));
  while (near + 1 != far && far + 1 != near) {
    const std::uint64_t middle = near / 2 + far / 2 + (near & far & 1U);
    (same_as_first(sign * std::bit_cast<double>(middle)) ? near : far) = middle;
  }
  return {sign * std::bit_cast<double>(near), sign * std::bit_cast<double>(far)};
}

/// The two questions one bit of x apart, between x = first and x = last, that `answer` tells apart; absent
/// where both ends have one answer. REQUIRES x a number of `question`, first and last of one sign.
template <typename Question, typename Answer>
std::optional<std::pair<Question, Question>> twins(Question& question, double& x, double first, double last,
                                                   Answer answer) {
  x = first;
  const auto of_first = answer(question);
  x = last;
  if (answer(question) == of_first) return std::nullopt;
  const auto [near, far] = straddling_doubles(first, last, [&](double middle) {
    x = middle;
    return answer(question) == of_first;
  });
  x = near;
  const Question one = question;
  x = far;
  return std::pair{one, question};
}

}  // namespace tps::vectors
