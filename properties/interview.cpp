#include "properties/interview.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <limits>

#include "properties/implementations/has_answer.hpp"
#include "reference/process/interrupt.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties {
namespace {

/// An answer that does not have what the operation's answers have.
[[noreturn]] void no_answer(Op op, const std::string& what) {
  throw Unanswered{{Outcome::Kind::failed, fmt::format("the answer to {} {}", operations::name(op), what)}};
}

std::optional<Wide> wide_from(const HexDigits& hex) {
  constexpr std::size_t kDigitsOfWide = 125;
  if (hex.digits.size() > kDigitsOfWide || std::abs(hex.exponent) > 1'000'000) return std::nullopt;
  Wide value(0);
  for (std::size_t k = 0; k < hex.digits.size(); k += 15) {
    const std::string digits = hex.digits.substr(k, 15);
    value = ldexp(value, 4 * static_cast<int>(digits.size())) + Wide(std::stoull(digits, nullptr, 16));
  }
  value = ldexp(value, static_cast<int>(hex.exponent));
  return hex.negative ? Wide(-value) : value;
}

std::optional<Wide> wide_from(const Json& value) {
  if (value.is_number()) return Wide(value.get<double>());
  if (!value.is_string()) return std::nullopt;
  const std::string& text = value.get_ref<const std::string&>();
  if (text == "inf") return std::numeric_limits<Wide>::infinity();
  if (text == "-inf") return -std::numeric_limits<Wide>::infinity();
  const std::optional<HexDigits> hex = split_hex(text);
  return hex ? wide_from(*hex) : std::nullopt;
}

Wide number_of(Op op, const char* key, const Json& value) {
  const std::optional<Wide> x = wide_from(value);
  if (!x) no_answer(op, fmt::format("has {} = {}, which is no hexadecimal float", key, tps::shown(value)));
  return *x;
}

const Json& field(Op op, const Json& out, const char* key) {
  const auto found = out.find(key);
  if (found == out.end()) no_answer(op, fmt::format("has no {}: {}", key, tps::shown(out)));
  return *found;
}

std::string word_of(Op op, const Json& out, const char* key) {
  const Json& value = field(op, out, key);
  if (!value.is_string()) no_answer(op, fmt::format("has {} = {}, which is no word", key, tps::shown(value)));
  constexpr std::size_t kLongestWord = 100;
  return printable(value.get<std::string>(), kLongestWord);  // reports quote it
}

WideVector vector_of(Op op, const char* key, const Json& value, int dimension) {
  if (!value.is_array() || static_cast<int>(value.size()) != dimension)
    no_answer(op, fmt::format("has {} = {}, which is no vector of {}", key, tps::shown(value), dimension));
  return {number_of(op, key, value[0]), number_of(op, key, value[1]),
          dimension > 2 ? number_of(op, key, value[2]) : Wide(0)};
}

Json hex(double x) {
  return to_hex<double>(x);
}

Time time_of(Op op, const Json& out) {
  Time time{word_of(op, out, "verdict"), std::nullopt};
  if (const auto t = out.find("t"); t != out.end() && !t->is_null()) time.t = number_of(op, "t", *t);
  return time;
}

}  // namespace

Vec3 Interview::passed(const WideVector& x) const {
  const Format format = subject_.format();
  const auto one = [&](const Wide& component) { return format.rounded(static_cast<double>(component)); };
  return {one(x.x), one(x.y), one(x.z)};
}

Json Interview::vector(const Vec3& x) const {
  Json list = Json::array();
  for (int k = 0; k < dimension_; ++k) list.push_back(hex(x[static_cast<std::size_t>(k)]));
  return list;
}

Json Interview::spin(const Vec3& x) const {
  return dimension_ == 2 ? hex(x[0]) : vector(x);
}

Json Interview::pair_input(const PairState& pair) const {
  return {{"u_A", vector(pair.u_A)},
          {"u_B", vector(pair.u_B)},
          {"v_A", vector(pair.v_A)},
          {"v_B", vector(pair.v_B)}};
}

Json Interview::ask(Op op, Json in) {
  interrupt::check();
  questions_.push_back({op, std::move(in)});
  Answer answer = subject_.ask(questions_.back());
  switch (answer.status) {
    case Answer::Status::answered:
      if (!answer.out.is_object()) no_answer(op, "is no object: " + tps::shown(answer.out));
      return std::move(answer.out);
    case Answer::Status::skipped:
      throw Unanswered{{Outcome::Kind::skipped, fmt::format("{}: {}", operations::name(op), answer.reason)}};
    case Answer::Status::refused:
      throw Unanswered{
          {has_answer(questions_.back(), subject_.format()) ? Outcome::Kind::refused : Outcome::Kind::outside,
           fmt::format("{}: {}", operations::name(op), answer.reason)}};
    default:
      throw Unanswered{{Outcome::Kind::failed, fmt::format("{}: {}", operations::name(op), answer.reason)}};
  }
}

std::vector<TimingKind> Interview::timing_kinds() const {
  std::vector<TimingKind> kinds{TimingKind::block, TimingKind::tether};
  std::erase_if(kinds, [&](TimingKind kind) { return !subject_.may_offer(operations::timing_of(kind)); });
  return kinds;
}

Wide Interview::distance(const PairState& pair, double dt) {
  Json in = pair_input(pair);
  in["dt"] = hex(dt);
  return number_of(Op::distance, "du", field(Op::distance, ask(Op::distance, in), "du"));
}

Time Interview::time(const LimitQuery& query) {
  const Op op = operations::timing_of(query.kind);
  Json in = pair_input(query.pair);
  in["L"] = hex(query.L);
  return time_of(op, ask(op, in));
}

Time Interview::block_time(const PairState& pair, double L) {
  return time({TimingKind::block, pair, L});
}
Time Interview::tether_time(const PairState& pair, double L) {
  return time({TimingKind::tether, pair, L});
}

std::string Interview::order(const LimitQuery& first, const LimitQuery& second) {
  const auto query = [this](const LimitQuery& q) {
    Json in{{"kind", q.kind == TimingKind::block ? "block" : "tether"}};
    in.update(pair_input(q.pair));
    in["L"] = hex(q.L);
    return in;
  };
  return word_of(Op::order, ask(Op::order, {{"first", query(first)}, {"second", query(second)}}), "order");
}

Velocities Interview::apply_impulse(const Masses& m, const Vec3& v_A, const Vec3& v_B, const Vec3& dp) {
  const Op op = Op::apply_impulse;
  const Json out = ask(
      op,
      {{"m_A", hex(m.A)}, {"m_B", hex(m.B)}, {"v_A", vector(v_A)}, {"v_B", vector(v_B)}, {"dp", vector(dp)}});
  return {vector_of(op, "v_A", field(op, out, "v_A"), dimension_),
          vector_of(op, "v_B", field(op, out, "v_B"), dimension_)};
}

WideVector Interview::collision_impulse(const PairState& pair, const Masses& m, double c) {
  const Op op = Op::collision_impulse;
  Json in = pair_input(pair);
  in.update({{"m_A", hex(m.A)}, {"m_B", hex(m.B)}, {"c", hex(c)}});
  return vector_of(op, "dp", field(op, ask(op, in), "dp"), dimension_);
}

WideVector Interview::revolution_impulse(const PairState& pair, const Masses& m, double c_revolve,
                                         double theta) {
  const Op op = Op::revolution_impulse;
  Json in = pair_input(pair);
  in.update({{"m_A", hex(m.A)},
             {"m_B", hex(m.B)},
             {"c_revolve", hex(c_revolve)},
             {"theta_revolve_deg", hex(theta)}});
  return vector_of(op, "dp", field(op, ask(op, in), "dp"), dimension_);
}

TetherAnswer Interview::tether_response(const PairState& pair, const Masses& m, double c_retract,
                                        double c_revolve, double theta) {
  const Op op = Op::tether_response;
  Json in = pair_input(pair);
  in.update({{"m_A", hex(m.A)},
             {"m_B", hex(m.B)},
             {"c_retract", hex(c_retract)},
             {"c_revolve", hex(c_revolve)},
             {"theta_revolve_deg", hex(theta)}});
  const Json out = ask(op, in);
  const auto result = [&](const char* key) { return vector_of(op, key, field(op, out, key), dimension_); };
  return {word_of(op, out, "kind"), result("dp"), {result("v_A"), result("v_B")}};
}

WideVector Interview::load(const Masses& m, const Vec3& v_A, const Vec3& v_B) {
  const Op op = Op::load;
  const Json out =
      ask(op, {{"m_A", hex(m.A)}, {"m_B", hex(m.B)}, {"v_A", vector(v_A)}, {"v_B", vector(v_B)}});
  return vector_of(op, "v_load", field(op, out, "v_load"), dimension_);
}

WideVector Interview::restitution_impulse(const Masses& m, const Vec3& v_A, const Vec3& v_B, const Vec3& dp) {
  const Op op = Op::restitution_impulse;
  const Json out = ask(
      op,
      {{"m_A", hex(m.A)}, {"m_B", hex(m.B)}, {"v_A", vector(v_A)}, {"v_B", vector(v_B)}, {"dp", vector(dp)}});
  return vector_of(op, "dp_AB", field(op, out, "dp_AB"), dimension_);
}

GroupVelocities Interview::group(const GroupCase& group) {
  const Op op = Op::group;
  Json in{{"bodies", Json::array()}, {"collisions", Json::array()}};
  for (std::size_t n = 0; n < group.m.size(); ++n)
    in["bodies"].push_back({{"m", hex(group.m[n])}, {"u", vector(group.u[n])}, {"v", vector(group.v[n])}});
  for (const GroupCollision& c : group.collisions)
    in["collisions"].push_back({{"i", c.i}, {"j", c.j}, {"limit", "inner"}, {"c", hex(c.c)}});
  const Json out = ask(op, in);
  const auto velocities = [&](const char* key) {
    const Json& list = field(op, out, key);
    if (!list.is_array() || list.size() != group.m.size())
      no_answer(op, fmt::format("has {} = {}, which is no list of {} velocities", key, tps::shown(list),
                                group.m.size()));
    std::vector<WideVector> result;
    for (const Json& v : list) result.push_back(vector_of(op, key, v, dimension_));
    return result;
  };
  return {velocities("loaded"), velocities("restituted")};
}

Time Interview::wall_time(const PairState& pair, double L, const Vec3& normal) {
  Json in = pair_input(pair);
  in.update({{"L", hex(L)}, {"normal", vector(normal)}});
  return time_of(Op::wall_time, ask(Op::wall_time, in));
}

Time Interview::drag_time(double gamma, double s) {
  return time_of(Op::drag_time, ask(Op::drag_time, {{"gamma", hex(gamma)}, {"s", hex(s)}}));
}

RoughAnswer Interview::rough_impulse(const RoughQuestion& q) {
  const Op op = Op::rough_impulse;
  Json in = pair_input(q.pair);
  in.update({{"spin_A", spin(q.spin_A)},
             {"spin_B", spin(q.spin_B)},
             {"m_A", hex(q.m.A)},
             {"m_B", hex(q.m.B)},
             {"R_A", hex(q.R_A)},
             {"R_B", hex(q.R_B)},
             {"c", hex(q.c)},
             {"mu", hex(q.mu)},
             {"beta0", hex(q.beta0)}});
  const Json out = ask(op, in);
  const auto result = [&](const char* key) { return vector_of(op, key, field(op, out, key), dimension_); };
  const auto turning = [&](const char* key) {
    if (dimension_ == 3) return result(key);
    const Json& spin = field(op, out, key);
    return WideVector{0, 0, number_of(op, key, spin.is_array() && spin.size() == 1 ? spin[0] : spin)};
  };
  return {word_of(op, out, "kind"),
          result("dp"),
          {result("v_A"), result("v_B")},
          turning("spin_A"),
          turning("spin_B")};
}

}  // namespace tps::properties
