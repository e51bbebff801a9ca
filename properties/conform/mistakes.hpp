// Mistakes as functions from a question to the answer that they give, in double: plain formulas, one slip
// each.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "properties/conform/expected.hpp"

namespace tps::properties::conform {

using Vec = std::vector<double>;

inline Vec operator+(Vec a, const Vec& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] += b[k];
  return a;
}
inline Vec operator*(double s, Vec a) {
  for (double& x : a) x *= s;
  return a;
}
inline Vec operator-(const Vec& a, const Vec& b) {
  return a + -1.0 * b;
}
inline double dot(const Vec& a, const Vec& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}
inline double norm(const Vec& a) {
  return std::sqrt(dot(a, a));
}

/// Relative to the larger of them; infinite where they do not correspond.
inline double apart(const Vec& a, const Vec& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  const double distance = norm(a - b);
  return distance == 0 ? 0 : distance / std::max(norm(a), norm(b));
}

/// A question's numbers by the names of the paper.
class Given {
 public:
  explicit Given(const Json& in) : in_(in) {}

  double number(const char* key) const { return numbers_of(in_.at(key)).value().at(0); }
  Vec vec(const char* key) const { return numbers_of(in_.at(key)).value(); }
  Vec r() const { return vec("u_B") - vec("u_A"); }
  Vec v() const { return vec("v_B") - vec("v_A"); }
  Vec n() const { return (1 / norm(r())) * r(); }
  double v_n() const { return dot(v(), n()); }
  Vec w() const { return v() - v_n() * n(); }
  double mu() const { return 1 / (1 / number("m_A") + 1 / number("m_B")); }
  double angle() const { return number("theta_revolve_deg") * M_PI / 180; }
  const Json& in() const { return in_; }

 private:
  const Json& in_;
};

/// Results by key; of a timing query "t", empty where nothing happens. Words are "kind" and "order".
struct Mistaken {
  std::vector<std::pair<std::string, Vec>> numbers;
  std::string word = {};
  std::vector<std::string> verdicts =
      {};               ///< of a timing query; any where empty, but not "static" of who moves
  double equal = 1e-9;  ///< an answer is this one within so much of its size
  double apart = 1e-7;  ///< and tells it from the right one beyond so much of it
};

struct Mistake {
  std::string name;
  std::vector<Op> ops;
  std::function<std::optional<Mistaken>(const Given&)> answer;
};

/// Each source adds its own.
void add_timing_mistakes(std::vector<Mistake>& mistakes);
void add_threshold_mistakes(std::vector<Mistake>& mistakes);
void add_response_mistakes(std::vector<Mistake>& mistakes);
void add_group_mistakes(std::vector<Mistake>& mistakes);
void add_effect_mistakes(std::vector<Mistake>& mistakes);

}  // namespace tps::properties::conform
