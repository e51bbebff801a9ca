// The strata of the responses: eqs. (3) to (7) and the choice between (4) and (5).
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "verify/operations/catalogue.hpp"
#include "verify/vectors/response_encounters.hpp"
#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace {

using namespace encounters;  // the tables below name them

Json input_of(const operations::Operation& operation, const Encounter& e) {
  const std::map<std::string, Json> every{{"u_A", hex(e.u_A)},
                                          {"u_B", hex(e.u_B)},
                                          {"v_A", hex(e.v_A)},
                                          {"v_B", hex(e.v_B)},
                                          {"dp", hex(e.dp)},
                                          {"m_A", hex(e.m_A)},
                                          {"m_B", hex(e.m_B)},
                                          {"c", hex(e.c)},
                                          {"c_retract", hex(e.c_retract)},
                                          {"c_revolve", hex(e.c_revolve)},
                                          {"theta_revolve_deg", hex(e.theta_revolve_deg)}};
  Json in;
  for (const std::string& key : operation.keys) in[key] = every.at(key);
  return in;
}

/// û needs two points, and eq. (5) a velocity across it.
bool has_answer(const operations::Operation& operation, const Encounter& e) {
  if (!operation.needs_axis) return true;
  if (e.u_A == e.u_B) return false;
  if (operation.op != Op::revolution_impulse) return true;
  double dot = 0, r = 0, v = 0;  // exact for the integers, the only stratum where v_ŵ = 0 is not by design
  for (std::size_t k = 0; k < e.u_A.size(); ++k) {
    dot += (e.u_B[k] - e.u_A[k]) * (e.v_B[k] - e.v_A[k]);
    r += (e.u_B[k] - e.u_A[k]) * (e.u_B[k] - e.u_A[k]);
    v += (e.v_B[k] - e.v_A[k]) * (e.v_B[k] - e.v_A[k]);
  }
  return dot * dot != r * v;
}

constexpr const char* kPlane = "planar";

struct Family {
  const char* name;
  const char* why;
  Encounter (*encounter)(Random&, int dimension);
};

constexpr Family response_families[] = {
    {"plain", "particles in a cube of edge 4, speeds of order 1", plain},
    {kPlane, "the same in the plane", plain},
    {"masses", "mass ratios up to 1e30, and walls", masses},
    {"coefficients", "restitution 0 and 1, the ends of the range of theta_revolve", coefficients},
    {"integers", "small integers: exact answers and zeros", integers},
    {"perpendicular", "r and v almost perpendicular", perpendicular},
    {"near_static", "the velocities differ by one unit in the last place", near_static},
    {"offset_origin", "two particles far from the origin", offset_origin},
    {"any_scale", "lengths times 2^j, velocities times 2^k", any_scale},
    {"float32", "every number exact in single precision", float32},
};
constexpr Family elastic = {"near_elastic", "restitution 1 - 2^-k, k from 2 to 45", near_elastic};
constexpr Family plastic = {"near_plastic", "restitution 2^-k, k from 2 to 45", near_plastic};
constexpr Family components = {"spread", "every component times a 2^-k of its own, k from 0 to 45", spread};

constexpr int kInSpace = 60;
constexpr int kFewInSpace = 30, kFewerInSpace = 18;

/// What one operation alone is asked.
struct OwnFamily {
  Op op;
  Family family;
  int in_space;
};

constexpr OwnFamily own_families[] = {
    {Op::collision_impulse, elastic, kInSpace},
    {Op::tether_response,
     {"boundary", "|c_retract v_n| = tan(theta) |v_w| exactly: either response passes", boundary},
     kInSpace},
    {Op::tether_response, {"near_boundary", "one bit beside that boundary", near_boundary}, kInSpace},
    {Op::tether_response,
     {"graded_boundary", "beside that boundary by 2^-k of it, k from 5 to 45", graded_boundary},
     kInSpace},
    {Op::tether_response,
     {"graded_across", "c_retract = 0, |v_w| = 2^-k |v_n|, k from 5 to 45", graded_across},
     kFewInSpace},
    {Op::apply_impulse,
     {"any_mass", "masses and impulses times 2^j, j from -120 to 120", any_mass},
     kFewerInSpace},
    {Op::collision_impulse,
     {"graded_masses", "m_B = m_A (1 -+ 2^-k), k from 5 to 45", graded_masses},
     kFewerInSpace},
    {Op::revolution_impulse,
     {"graded_angle", "multiples of 15 degrees times 1 -+ 2^-k, k from 5 to 45", graded_angle},
     kFewerInSpace},
    {Op::revolution_impulse, elastic, kFewerInSpace},
    {Op::tether_response, elastic, kFewerInSpace},
};

bool is_planar(const Family& family, std::uint64_t number, int in_space) {
  return family.name == std::string_view(kPlane) || dimension_of_case(number, in_space) == 2;
}

void add_family(std::vector<Stratum>& strata, const operations::Operation& operation, const Family& family,
                int in_space = kInSpace) {
  strata.push_back({operation.op, family.name, family.why, in_space + kInThePlane,
                    [&operation, family, in_space](Random& random, std::uint64_t number) -> Problem {
                      const bool planar = is_planar(family, number, in_space);
                      Encounter encounter;
                      do encounter = family.encounter(random, planar ? 2 : 3);
                      while (!has_answer(operation, encounter));
                      std::vector<std::string> tags{family.name};
                      if (planar && family.name != std::string_view(kPlane)) tags.emplace_back(kPlane);
                      return {input_of(operation, encounter), tags};
                    }});
}

}  // namespace

void add_response_strata(std::vector<Stratum>& strata) {
  for (const Op op : {Op::apply_impulse, Op::collision_impulse, Op::revolution_impulse, Op::tether_response,
                      Op::load, Op::restitution_impulse}) {
    const operations::Operation& operation = operations::operation(op);
    for (const Family& family : response_families) add_family(strata, operation, family);
    for (const auto& [whose, family, in_space] : own_families) {
      if (whose == op) add_family(strata, operation, family, in_space);
    }
    const bool restores = std::any_of(operation.keys.begin(), operation.keys.end(),
                                      [](const std::string& key) { return key.starts_with("c"); });
    add_family(strata, operation, restores ? plastic : components, kFewInSpace);
  }
}

}  // namespace tps::vectors
