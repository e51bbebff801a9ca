// The equations of responses in six scalars, as the study asks them: in three dimensions.
#include <limits>

#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/scalars.hpp"
#include "verify/cost/response_level.hpp"

namespace tps::cost {
namespace {

template <typename Scalar>
Vector<Scalar, 3> vector_of(const double (&x)[3]) {
  return {Scalar(x[0]), Scalar(x[1]), Scalar(x[2])};
}

template <typename Scalar>
ResponseAnswer answer_of(const Vector<Scalar, 3>& dp) {
  return {{static_cast<double>(dp[0]), static_cast<double>(dp[1]), static_cast<double>(dp[2])}};
}

template <typename Scalar>
CollisionFrame<Scalar, 3> frame_of(const ResponseQuestion& q) {
  return collision_frame<Scalar, 3>(vector_of<Scalar>(q.u_A), vector_of<Scalar>(q.u_B),
                                    vector_of<Scalar>(q.v_A), vector_of<Scalar>(q.v_B));
}

template <typename Scalar>
ResponseAnswer collision(const ResponseQuestion& q) {
  return answer_of<Scalar>(
      collision_impulse<Scalar, 3>(frame_of<Scalar>(q), Scalar(q.m_A), Scalar(q.m_B), Scalar(q.c)));
}

template <typename Scalar>
ResponseAnswer revolution(const ResponseQuestion& q) {
  return answer_of<Scalar>(revolution_impulse<Scalar, 3>(frame_of<Scalar>(q), Scalar(q.m_A), Scalar(q.m_B),
                                                         Scalar(q.c_revolve), Scalar(q.theta_revolve_deg)));
}

template <typename Scalar>
ResponseAnswer restitution(const ResponseQuestion& q) {
  return answer_of<Scalar>(restitution_impulse<Scalar, 3>(Scalar(q.m_A), Scalar(q.m_B),
                                                          vector_of<Scalar>(q.v_A), vector_of<Scalar>(q.v_B),
                                                          vector_of<Scalar>(q.dp)));
}

template <typename Scalar>
ResponseAnswer tether(const ResponseQuestion& q) {
  const TetherResponse<Scalar, 3> response =
      tether_response<Scalar, 3>(frame_of<Scalar>(q), Scalar(q.m_A), Scalar(q.m_B), Scalar(q.c_retract),
                                 Scalar(q.c_revolve), Scalar(q.theta_revolve_deg));
  ResponseAnswer answer = answer_of<Scalar>(response.dp);
  answer.revolves = response.kind == TetherResponseKind::revolve;
  return answer;
}

template <auto ask>
void throughput(std::span<const ResponseQuestion> questions) {
  for (const ResponseQuestion& question : questions) {
    const ResponseAnswer answer = ask(question);
    asm volatile("" : : "m"(answer) : "memory");  // keeps the compiler from leaving out what nobody reads
  }
}

template <auto ask>
ResponseVariant variant(operations::Op op, std::string_view scalar, int bits) {
  return {op, std::string(scalar), bits, ask, throughput<ask>};
}

template <typename Scalar>
void add(std::vector<ResponseVariant>& to) {
  constexpr int bits = std::numeric_limits<Scalar>::digits;
  constexpr std::string_view scalar = scalar_name<Scalar>;
  to.push_back(variant<collision<Scalar>>(operations::Op::collision_impulse, scalar, bits));
  to.push_back(variant<revolution<Scalar>>(operations::Op::revolution_impulse, scalar, bits));
  to.push_back(variant<restitution<Scalar>>(operations::Op::restitution_impulse, scalar, bits));
  to.push_back(variant<tether<Scalar>>(operations::Op::tether_response, scalar, bits));
}

}  // namespace

std::vector<ResponseVariant> response_variants() {
  std::vector<ResponseVariant> all;
  add<float>(all);
  add<double>(all);
  add<long double>(all);
  add<Quad>(all);
  add<Mp50>(all);
  add<Mp100>(all);
  return all;
}

}  // namespace tps::cost
