// When a pair next has an event at a limit, by the timing that the run was asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "reference/engine/clock.hpp"
#include "reference/engine/timing.hpp"
#include "reference/equations/directed_rounding.hpp"
#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"
#include "reference/equations/periodic_image.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// Two particles at one moment, the later of their two clocks.
template <typename Scalar, int D>
struct PairView {
  int i, j;  ///< i < j
  Time<Scalar> start;
  Vector<Scalar, D> u_i, u_j, v_i, v_j;
};

/// The same in a periodic box: the places of the base are 0 and the rounded difference to the image of j.
template <typename Scalar, int D>
struct ImagedPairView : PairView<Scalar, D> {
  Vector<Scalar, D> stored_i, stored_j;  ///< the places themselves
  PeriodicImage<Scalar, D> image;
};

/// What an effect asks about a pair: when is it next at this distance?
template <typename Scalar>
struct LimitQuestion {
  TimingKind kind;
  Scalar distance;
  bool has_responded;  ///< at this limit, and no velocity has changed since (semantics §1)
};

/// Whether certified timing is defined for runs in a scalar: its numbers are doubles.
template <typename Scalar>
inline constexpr bool certifiable = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;

template <typename Scalar, int D>
class PairTiming {
 public:
  using View = PairView<Scalar, D>;
  using ImagedView = ImagedPairView<Scalar, D>;
  using Question = LimitQuestion<Scalar>;

  explicit PairTiming(const TimingChoice& choice) : choice_(choice) {
    if (choice.timing != Timing::certified) return;
    if (!certifiable<Scalar>) throw std::invalid_argument("certified timing is for float and double");
    if (choice.certifier == nullptr) throw std::invalid_argument("certified timing needs a certifier");
  }

  bool certified() const { return choice_.timing == Timing::certified; }
  bool literal() const { return choice_.timing == Timing::paper; }

  /// The time from the view's start to the pair's next event at the limit, if there is one: NaN where the
  /// formula left the range of the scalar, so that it cannot tell.
  ///
  /// A pair that has just been pulled can only come back by way of the inside. Where rounding left it so far
  /// outside that its path misses the inside (`turning`), it is taken to be where real arithmetic has it, at
  /// the limit (c = 0: t = −2h/a, twice the time to the turning point); else it would never be pulled again.
  template <typename AnyView>
  std::optional<Scalar> next(const AnyView& pair, const Question& question) const {
    const CollisionTime<Scalar> answer = answered(pair, question);
    if (!question.has_responded) return answer.t;
    if (answer.verdict == TimingVerdict::turning) return Scalar(2) * *answer.t;
    if (answer.verdict == TimingVerdict::hit) return answer.t;
    if (question.kind == TimingKind::block || answer.verdict == TimingVerdict::static_pair)
      return std::nullopt;
    return pulled_again(pair);
  }

  /// The moment that next() rounds. REQUIRES certified().
  template <typename AnyView>
  Moment moment(const AnyView& pair, const Question& question) const {
    Moment moment = known(pair.start);
    moment.query = lifted_query(pair, question);
    if (question.has_responded &&
        choice_.certifier->answer(*moment.query).verdict == TimingVerdict::turning) {
      moment.multiple = 2;
    }
    return moment;
  }

  /// The same of a plane, for a question that next() does not know.
  static Moment moment(const Time<Scalar>& start, const TimingQuery& query) {
    Moment moment = known(start);
    moment.query = query;
    return moment;
  }

  /// The exact answer to a question, its time rounded once; none where it is not valid. REQUIRES certified().
  std::optional<Scalar> certified_time(const TimingQuery& query) const {
    if constexpr (certifiable<Scalar>) {
      if (!valid(query)) return std::nullopt;
      const CollisionTime<double> answer = choice_.certifier->answer(query);
      if (answer.t) return rounded(query, *answer.t);
    }
    return std::nullopt;
  }

  /// A vector of the scalar in doubles, as queries have it.
  static std::array<double, 3> lifted(const Vector<Scalar, D>& x) {
    std::array<double, 3> result{};
    for (int k = 0; k < D; ++k) result[static_cast<std::size_t>(k)] = static_cast<double>(x[k]);
    return result;
  }

  /// A time that is not the answer to a query. REQUIRES certified().
  static Moment known(const Time<Scalar>& t) {
    return {static_cast<double>(t.hi), static_cast<double>(t.lo), std::nullopt, 1};
  }

  /// REQUIRES certified().
  std::weak_ordering order(const Moment& first, const Moment& second) const {
    return choice_.certifier->order(first, second);
  }

 private:
  /// When a pair that was pulled (D23), and that rounded coefficients have at or beyond its limit and
  /// separating, is pulled again. Directed rounding made its exact h negative, however small: it comes back
  /// at −2h/a. Where h ≥ 0 a stored position has been rounded since (another tether of the particle broke):
  /// at once.
  static Scalar pulled_again(const View& pair) { return pulled_again(pair, pair.u_i, pair.u_j, nullptr); }
  static Scalar pulled_again(const ImagedView& pair) {
    return pulled_again(pair, pair.stored_i, pair.stored_j, &pair.image);
  }
  static Scalar pulled_again(const View& pair, const Vector<Scalar, D>& u_i, const Vector<Scalar, D>& u_j,
                             const PeriodicImage<Scalar, D>* image) {
    if (normal_sign<Scalar, D>(u_i, u_j, pair.v_i, pair.v_j, image) >= 0) return Scalar(0);
    const Dyadic h = detail::exact_dot<Scalar, D>(u_i, u_j, pair.v_i, pair.v_j, -1, image);
    const Dyadic a = detail::exact_dot<Scalar, D>(pair.v_i, pair.v_j, pair.v_i, pair.v_j, -1);
    return rounded_quotient<Scalar>(-(h + h), a, Rounding::up);
  }

  template <typename AnyView>
  CollisionTime<Scalar> answered(const AnyView& pair, const Question& question) const {
    const bool block = question.kind == TimingKind::block;
    if constexpr (certifiable<Scalar>) {
      if (certified()) return certified_answer(pair, question);
    }
    if (literal()) {
      if (!paper_roots_in_range<Scalar, D>(pair.u_i, pair.u_j, pair.v_i, pair.v_j, question.distance)) {
        return {TimingVerdict::hit, std::numeric_limits<Scalar>::quiet_NaN()};
      }
      CollisionTime<Scalar> answer =
          (block ? paper_block_time<Scalar, D> : paper_tether_time<Scalar, D>)(pair.u_i, pair.u_j, pair.v_i,
                                                                               pair.v_j, question.distance);
      if (occurs(answer.verdict) && !answer.t) answer.t = std::numeric_limits<Scalar>::infinity();
      return answer;
    }
    return (block ? block_time<Scalar, D> : tether_time<Scalar, D>)(pair.u_i, pair.u_j, pair.v_i, pair.v_j,
                                                                    question.distance);
  }

  /// Positions that have left the range of the scalar have no event any more.
  template <typename AnyView>
  CollisionTime<Scalar> certified_answer(const AnyView& pair, const Question& question) const {
    const TimingQuery query = lifted_query(pair, question);
    if (!valid(query)) return {TimingVerdict::static_pair, std::nullopt};
    const CollisionTime<double> answer = choice_.certifier->answer(query);
    if (!answer.t) return {answer.verdict, std::nullopt};
    return {answer.verdict, rounded(query, *answer.t)};
  }

  static TimingQuery lifted_query(const View& pair, const Question& question) {
    return {question.kind,    lifted(pair.u_i), lifted(pair.u_j),
            lifted(pair.v_i), lifted(pair.v_j), static_cast<double>(question.distance)};
  }
  static TimingQuery lifted_query(const ImagedView& pair, const Question& question) {
    return {question.kind,
            lifted(pair.stored_i),
            lifted(pair.stored_j),
            lifted(pair.v_i),
            lifted(pair.v_j),
            static_cast<double>(question.distance),
            {},
            lifted(pair.image.n),
            lifted(pair.image.edges)};
  }

  /// The scalar nearest to the exact time of which t is the nearest double.
  ///
  /// Rounding t to float is rounding twice, which errs only where t lies half-way between two floats and the
  /// exact time does not: there the exact order of the two decides.
  Scalar rounded(const TimingQuery& query, double t) const {
    if constexpr (std::is_same_v<Scalar, double>) {
      return t;
    } else {
      const float nearest = static_cast<float>(t);
      const float other = std::nextafter(nearest, nearest < t ? std::numeric_limits<float>::infinity() : 0.F);
      const bool half_way = nearest != t && t - nearest == other - t;
      if (!half_way) return nearest;
      const std::weak_ordering exact = order({0, 0, query, 1}, {t, 0, std::nullopt, 1});
      if (exact < 0) return std::min(nearest, other);
      if (exact > 0) return std::max(nearest, other);
      return nearest;
    }
  }

  TimingChoice choice_;
};

}  // namespace tps
