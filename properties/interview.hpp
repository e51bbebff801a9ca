// Questions of laws to an implementation, in the words of the paper; every one is remembered, so that a
// broken law can be written down as known answers. Heavy header: only sources of laws include it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/implementation.hpp"
#include "properties/outcome.hpp"
#include "properties/wide.hpp"
#include "reference/equations/timing_query.hpp"

namespace tps::properties {

/// The answer to a timing query.
struct Time {
  std::string verdict;
  std::optional<Wide> t;

  friend bool operator==(const Time&, const Time&) = default;
};

struct Velocities {
  WideVector v_A, v_B;
};

struct TetherAnswer {
  std::string kind;
  WideVector dp;
  Velocities after;
};

/// A collision in a group.
struct GroupCollision {
  int i, j;
  double c;
};

/// Inner collisions, in order, of bodies at one instant.
struct GroupCase {
  std::vector<double> m;
  std::vector<Vec3> u, v;
  std::vector<GroupCollision> collisions;
};

/// A rebound of rough particles; in the plane a spin is its first number.
struct RoughQuestion {
  PairState pair;
  Vec3 spin_A, spin_B;
  Masses m;
  double R_A, R_B, c, mu, beta0;
};

/// In the plane a spin stands along z.
struct RoughAnswer {
  std::string kind;
  WideVector dp;
  Velocities after;
  WideVector spin_A, spin_B;
};

struct GroupVelocities {
  std::vector<WideVector> loaded, restituted;
};

/// One of the two timing queries.
struct LimitQuery {
  TimingKind kind;
  PairState pair;
  double L;
};

class Interview {
 public:
  Interview(Implementation& subject, int dimension) : subject_(subject), dimension_(dimension) {}

  Format format() const { return subject_.format(); }
  /// Unit roundoff of results.
  Wide u() const { return ldexp(Wide(1), -subject_.format().bits); }
  /// Unit roundoff of a result that is passed on as the input of another question: that of double at best.
  Wide u_passed() const { return ldexp(Wide(1), -std::min(subject_.format().bits, 53)); }
  /// A result as it is passed on.
  Vec3 passed(const WideVector& x) const;

  /// Those of the two timing queries that the subject offers; both where it does not say.
  std::vector<TimingKind> timing_kinds() const;

  /// All of these throw Unanswered where there is no answer, and interrupt::Interrupted.
  Wide distance(const PairState& pair, double dt);
  Time block_time(const PairState& pair, double L);
  Time tether_time(const PairState& pair, double L);
  Time time(const LimitQuery& query);
  std::string order(const LimitQuery& first, const LimitQuery& second);
  Velocities apply_impulse(const Masses& m, const Vec3& v_A, const Vec3& v_B, const Vec3& dp);
  WideVector collision_impulse(const PairState& pair, const Masses& m, double c);
  WideVector revolution_impulse(const PairState& pair, const Masses& m, double c_revolve, double theta);
  TetherAnswer tether_response(const PairState& pair, const Masses& m, double c_retract, double c_revolve,
                               double theta);
  WideVector load(const Masses& m, const Vec3& v_A, const Vec3& v_B);
  WideVector restitution_impulse(const Masses& m, const Vec3& v_A, const Vec3& v_B, const Vec3& dp);
  GroupVelocities group(const GroupCase& group);
  Time wall_time(const PairState& pair, double L, const Vec3& normal);
  Time drag_time(double gamma, double s);
  RoughAnswer rough_impulse(const RoughQuestion& question);

  const std::vector<Question>& questions() const { return questions_; }

 private:
  Json vector(const Vec3& x) const;
  Json spin(const Vec3& x) const;
  Json pair_input(const PairState& pair) const;
  Json ask(Op op, Json in);

  Implementation& subject_;
  int dimension_;
  std::vector<Question> questions_;
};

/// Thrown by questions without an answer.
struct Unanswered {
  Outcome outcome;
};

}  // namespace tps::properties
