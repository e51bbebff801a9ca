#include "properties/implementations/serve_library.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "properties/c_abi/tps_implementation.h"
#include "properties/case.hpp"
#include "properties/implementation.hpp"
#include "properties/implementations/library_table.hpp"
#include "reference/equations/timing_verdict.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::properties {
namespace {

/// Not offered: a null pointer in the table.
struct NotOffered {};
/// The library says that there is no answer.
struct Refused {};

/// One request, answered through the table.
class Request {
 public:
  Request(const tps_implementation& table, const Json& in) : table_(table), in_(in) {}

  Json answer(Op op) {
    switch (op) {
      case Op::block_time:
        return time(table_.block_time);
      case Op::tether_time:
        return time(table_.tether_time);
      case Op::order:
        return order();
      case Op::apply_impulse:
        return apply_impulse();
      case Op::collision_impulse:
        call(table_.collision_impulse, &read_pair(in_), m_A(), m_B(), number("c"), dp_.data());
        return {{"dp", vector(dp_)}};
      case Op::revolution_impulse:
        call(table_.revolution_impulse, &read_pair(in_), m_A(), m_B(), number("c_revolve"),
             number("theta_revolve_deg"), dp_.data());
        return {{"dp", vector(dp_)}};
      case Op::tether_response:
        return tether_response();
      case Op::load:
        return load();
      case Op::restitution_impulse:
        return restitution_impulse();
      case Op::group:
        return group();
      case Op::wall_time:
        return wall_time();
      case Op::drag_time:
        return drag_time();
      case Op::rough_impulse:
        return rough_impulse();
      case Op::distance:
      case Op::paper_time:
      case Op::next_event:
      case Op::simulate:
        break;
    }
    throw NotOffered{};
  }

 private:
  template <typename Function, typename... Arguments>
  static void call(Function function, Arguments... arguments) {
    if (function == nullptr) throw NotOffered{};
    if (function(arguments...) != TPS_ANSWERED) throw Refused{};
  }

  double number(const char* key) const { return number_of(in_.at(key)); }
  double m_A() const { return number("m_A"); }
  double m_B() const { return number("m_B"); }
  Vec3 read_vector(const Json& from, const char* key) {
    const Json& list = from.at(key);
    dimension_ = static_cast<int>(list.size());
    return {number_of(list.at(0)), number_of(list.at(1)), dimension_ > 2 ? number_of(list.at(2)) : 0};
  }
  void put(double (&to)[3], const Vec3& x) const { std::copy(x.begin(), x.end(), to); }
  const tps_pair& read_pair(const Json& from) {
    put(pair_.u_A, read_vector(from, "u_A"));
    put(pair_.u_B, read_vector(from, "u_B"));
    put(pair_.v_A, read_vector(from, "v_A"));
    put(pair_.v_B, read_vector(from, "v_B"));
    pair_.dimension = dimension_;
    return pair_;
  }

  static Json hex(double x) { return std::isnan(x) ? Json("nan") : Json(to_hex<double>(x)); }
  Json vector(const Vec3& x) const {
    Json list = Json::array();
    for (int k = 0; k < dimension_; ++k) list.push_back(hex(x[static_cast<std::size_t>(k)]));
    return list;
  }

  /// In the plane a spin is one number, about the third axis.
  Vec3 read_spin(const char* key) {
    return in_.at(key).is_array() ? read_vector(in_, key) : Vec3{0, 0, number(key)};
  }
  Json spin(const double (&x)[3]) const { return dimension_ == 2 ? hex(x[2]) : vector({x[0], x[1], x[2]}); }

  template <typename Function>
  Json time(Function function) {
    tps_time answer{};
    call(function, &read_pair(in_), number("L"), &answer);
    return time_json(answer);
  }
  static Json time_json(const tps_time& answer) {
    if (answer.verdict < TPS_STATIC || answer.verdict > TPS_TURNING)
      return {{"verdict", fmt::format("number {}", static_cast<int>(answer.verdict))}};
    return {{"verdict", std::string(name(static_cast<TimingVerdict>(answer.verdict)))},
            {"t", answer.occurs != 0 ? hex(answer.t) : Json()}};
  }

  tps_query read_query(const Json& from) {
    return {from.at("kind") == "tether" ? TPS_TETHER : TPS_BLOCK, read_pair(from), number_of(from.at("L"))};
  }
  Json order() {
    const tps_query first = read_query(in_.at("first")), second = read_query(in_.at("second"));
    tps_order answer{};
    call(table_.order, &first, &second, &answer);
    constexpr std::array<const char*, 4> names{"before", "after", "equal", "none"};
    const auto n = static_cast<std::size_t>(answer);
    return {{"order", n < names.size() ? names[n] : "a number that stands for no order"}};
  }

  Json wall_time() {
    tps_time answer{};
    const Vec3 normal = read_vector(in_, "normal");
    call(table_.wall_time, &read_pair(in_), number("L"), normal.data(), &answer);
    return time_json(answer);
  }

  Json drag_time() const {
    tps_time answer{};
    call(table_.drag_time, number("gamma"), number("s"), &answer);
    return {{"verdict", answer.occurs != 0 ? "reached" : "never"},
            {"t", answer.occurs != 0 ? hex(answer.t) : Json()}};
  }

  Json rough_impulse() {
    tps_rough_pair q{};
    q.pair = read_pair(in_);
    put(q.spin_A, read_spin("spin_A"));
    put(q.spin_B, read_spin("spin_B"));
    q.m_A = m_A(), q.m_B = m_B(), q.R_A = number("R_A"), q.R_B = number("R_B");
    q.c = number("c"), q.mu = number("mu"), q.beta0 = number("beta0");
    tps_contact contact{};
    double spin_A[3]{}, spin_B[3]{};
    call(table_.rough_impulse, &q, &contact, dp_.data(), new_A_.data(), new_B_.data(), &spin_A[0],
         &spin_B[0]);
    return {{"kind", contact == TPS_SLIDES ? "slides" : "sticks"},
            {"dp", vector(dp_)},
            {"v_A", vector(new_A_)},
            {"v_B", vector(new_B_)},
            {"spin_A", spin(spin_A)},
            {"spin_B", spin(spin_B)}};
  }

  Json apply_impulse() {
    const Vec3 v_A = read_vector(in_, "v_A"), v_B = read_vector(in_, "v_B"), dp = read_vector(in_, "dp");
    call(table_.apply_impulse, dimension_, m_A(), m_B(), v_A.data(), v_B.data(), dp.data(), new_A_.data(),
         new_B_.data());
    return {{"v_A", vector(new_A_)}, {"v_B", vector(new_B_)}};
  }

  Json load() {
    const Vec3 v_A = read_vector(in_, "v_A"), v_B = read_vector(in_, "v_B");
    call(table_.load, dimension_, m_A(), m_B(), v_A.data(), v_B.data(), new_A_.data());
    return {{"v_load", vector(new_A_)}};
  }

  Json restitution_impulse() {
    const Vec3 v_A = read_vector(in_, "v_A"), v_B = read_vector(in_, "v_B"), dp = read_vector(in_, "dp");
    call(table_.restitution_impulse, dimension_, m_A(), m_B(), v_A.data(), v_B.data(), dp.data(), dp_.data());
    return {{"dp_AB", vector(dp_)}};
  }

  Json tether_response() {
    tps_response kind{};
    call(table_.tether_response, &read_pair(in_), m_A(), m_B(), number("c_retract"), number("c_revolve"),
         number("theta_revolve_deg"), &kind, dp_.data(), new_A_.data(), new_B_.data());
    return {{"kind", kind == TPS_REVOLVE ? "revolve" : "retract"},
            {"dp", vector(dp_)},
            {"v_A", vector(new_A_)},
            {"v_B", vector(new_B_)}};
  }

  Json group() {
    std::vector<tps_body> bodies;
    std::vector<tps_collision> collisions;
    for (const Json& each : in_.at("bodies")) {
      bodies.push_back({number_of(each.at("m")), {}, {}});
      put(bodies.back().u, read_vector(each, "u"));
      put(bodies.back().v, read_vector(each, "v"));
    }
    for (const Json& each : in_.at("collisions"))
      collisions.push_back({each.at("i").get<int>(), each.at("j").get<int>(), number_of(each.at("c"))});
    struct Row {
      double v[3];
    };
    std::vector<Row> loaded(bodies.size()), restituted(bodies.size());
    call(table_.group, dimension_, static_cast<int>(bodies.size()), bodies.data(),
         static_cast<int>(collisions.size()), collisions.data(), &loaded.data()->v, &restituted.data()->v);
    const auto rows = [this](const std::vector<Row>& velocities) {
      Json list = Json::array();
      for (const Row& row : velocities) list.push_back(vector({row.v[0], row.v[1], row.v[2]}));
      return list;
    };
    return {{"loaded", rows(loaded)}, {"restituted", rows(restituted)}};
  }

  const tps_implementation& table_;
  const Json& in_;
  int dimension_ = 3;
  tps_pair pair_{};
  Vec3 dp_{}, new_A_{}, new_B_{};
};

Json reply_to(const tps_implementation& table, const Json& request) {
  if (request.contains("hello"))
    return {{"name", table.name}, {"bits", table.bits}, {"ops", operations_in(table)}, {"group", "inner"}};
  Json reply{{"seq", request.value("seq", Json())}};
  try {
    const operations::Operation* operation = operations::find(request.at("op").get<std::string>());
    if (operation == nullptr) throw NotOffered{};
    reply["out"] = Request(table, request.at("in")).answer(operation->op);
  } catch (const NotOffered&) {
    reply["skip"] = "unknown_op";
  } catch (const Refused&) {
    reply["error"] = "refused";
  } catch (const Json::exception&) {
    reply["error"] = "bad_request";  // a key that is missing, or of another kind
  }
  return reply;
}

Json reply_to_line(const tps_implementation& table, const std::string& line) {
  try {
    const Json request = parse_plain_json(line, "request");
    if (request.is_object()) return reply_to(table, request);
    return {{"seq", nullptr}, {"error", "bad_request"}};
  } catch (const InputError& error) {
    return {{"seq", nullptr}, {"error", "bad_json"}, {"message", first_problem(error)}};
  }
}

/// Requests and replies on descriptors of our own: what a library prints or closes is not the conversation.
class Streams {
 public:
  Streams() : requests_(::fdopen(apart(STDIN_FILENO), "r")), replies_(::fdopen(apart(STDOUT_FILENO), "w")) {
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  bool read(std::string& line) {
    line.clear();
    for (int c = std::fgetc(requests_); c != EOF; c = std::fgetc(requests_)) {
      if (c == '\n') return true;
      line.push_back(static_cast<char>(c));
    }
    return false;
  }
  void write(const Json& reply) {
    const std::string text = json_text(reply) + "\n";
    std::fwrite(text.data(), 1, text.size(), replies_);
    std::fflush(replies_);
  }

 private:
  static int apart(int standard) {
    constexpr int kAbove = 100;
    return ::fcntl(standard, F_DUPFD_CLOEXEC, kAbove);
  }
  std::FILE* requests_;
  std::FILE* replies_;
};

}  // namespace

int serve_library(const std::string& path) {
  Streams streams;
  std::string line;
  try {
    const tps_implementation table = library_table(path);
    while (streams.read(line)) streams.write(reply_to_line(table, line));
    return 0;
  } catch (const std::runtime_error& error) {
    streams.write({{"error", error.what()}});
    return 1;
  }
}

}  // namespace tps::properties
