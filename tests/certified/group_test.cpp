// Certified groups: the paper's X-Y-Z by hand, grounding, refusals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "reference/text/input_error.hpp"
#include "verify/certified/certified_response.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::certified {
namespace {

using operations::GroupInput;

/// X flies at Y and Z, which are at rest and touch; m_Y = m/1000 to scale, so that all masses are doubles.
GroupInput chain(double c) {
  GroupInput input;
  input.bodies = {{1000, {0, 0}, {1, 0}}, {1, {1, 0}, {0, 0}}, {1000, {2, 0}, {0, 0}}};
  input.collisions = {{0, 1, false, c}, {1, 2, false, c}};
  return input;
}

// By hand: masses 1000, 1, 1000; v_load = 1000/1001, then 1000/2001.
TEST(CertifiedGroup, ThePapersChain) {
  const GroupResponse elastic = certified_group(chain(1));
  for (const EnclosedVector& v : elastic.loaded) EXPECT_EQ(v[0].nearest, 1000.0 / 2001.0);
  EXPECT_EQ(elastic.restituted[0][0].nearest, -1.0 / 2001.0);
  EXPECT_EQ(elastic.restituted[1][0].nearest, 2000.0 / 2001.0);
  EXPECT_EQ(elastic.restituted[2][0].nearest, 2000.0 / 2001.0);
}

// c = 1/2: X and Y part as −μ c v; Y and Z alike, with μ = 1001·1000/2001.
TEST(CertifiedGroup, AnInelasticChain) {
  const GroupResponse half = certified_group(chain(0.5));
  EXPECT_EQ(half.restituted[0][0].nearest, 499.5 / 2001.0);
  EXPECT_EQ(half.restituted[1][0].nearest, 1500.0 / 2001.0);
  EXPECT_EQ(half.restituted[2][0].nearest, 1500.0 / 2001.0);
}

// One load and one restitution give the velocities of eq. (4) alone.
TEST(CertifiedGroup, APairPartsAsIfItHadNotBeenLoaded) {
  GroupInput input;
  input.bodies = {{3, {0, 0, 0}, {1, 2, 3}}, {5, {1, 2, 2}, {-1, 0, 0.1}}};
  input.collisions = {{0, 1, false, 0.7}};
  const GroupResponse grouped = certified_group(input);
  const operations::Operation& eq4 = *operations::find("collision_impulse");
  const operations::Operation& eq3 = *operations::find("apply_impulse");
  operations::Input in{3,
                       {{"u_A", {0, 0, 0}},
                        {"u_B", {1, 2, 2}},
                        {"v_A", {1, 2, 3}},
                        {"v_B", {-1, 0, 0.1}},
                        {"m_A", {3}},
                        {"m_B", {5}},
                        {"c", {0.7}}}};
  const EnclosedVector dp = certified_response(eq4.op, in).values.at("dp");
  in.values["dp"] = {dp[0].nearest, dp[1].nearest, dp[2].nearest};
  const Response free = certified_response(eq3.op, in);
  for (std::size_t k = 0; k < 3; ++k) {  // Δp was rounded once: an ulp of velocities of size 1 to 4
    EXPECT_NEAR(grouped.restituted[0][k].nearest, free.values.at("v_A")[k].nearest, 0x1p-50);
    EXPECT_NEAR(grouped.restituted[1][k].nearest, free.values.at("v_B")[k].nearest, 0x1p-50);
  }
}

// A wall grounds what hits it: it keeps its velocity, two bodies grounded on it stay apart.
TEST(CertifiedGroup, AWallJoinsNoGroup) {
  GroupInput input;
  input.bodies = {
      {HUGE_VAL, {0, 0}, {0, 0}}, {1, {1, 0}, {-1, 0}}, {2, {-1, 0}, {1, 0}}, {1, {2, 0}, {-4, 0}}};
  input.collisions = {{0, 1, false, 1}, {0, 2, false, 0.5}, {1, 3, false, 1}};
  const GroupResponse response = certified_group(input);
  for (const EnclosedVector& v : response.loaded) EXPECT_EQ(v[0].nearest, 0);
  EXPECT_EQ(response.restituted[0][0].nearest, 0);
  EXPECT_EQ(response.restituted[1][0].nearest, 1);  // the later load was against infinite mass
  EXPECT_EQ(response.restituted[2][0].nearest, -0.5);
  EXPECT_EQ(response.restituted[3][0].nearest, 4);
}

TEST(CertifiedGroup, TetheringCollisionsRetractOrRevolve) {
  GroupInput input;
  input.bodies = {{1, {0, 0}, {0, 0}}, {1, {1, 0}, {1, 0}}, {2, {1, 1}, {0.5, 1}}};
  input.collisions = {{0, 1, true, 0, 1, 1, 45}, {1, 2, true, 0, 1, 1, 45}};
  const GroupResponse response = certified_group(input);
  EXPECT_EQ(response.loaded[2][0].nearest, 0.5);
  EXPECT_EQ(response.loaded[2][1].nearest, 0.5);
  EXPECT_EQ(response.restituted[0][0].nearest, 1);  // exchanges velocities with body 1
  EXPECT_EQ(response.restituted[1][0].nearest, 0);
  EXPECT_EQ(response.restituted[2][1].nearest, 0);
  EXPECT_FALSE(response.boundary);
}

std::string refusal(const GroupInput& input) {
  try {
    certified_group(input);
  } catch (const operations::NoAnswer& why) {
    const InputError error = why.in("", 0, "");
    return error.what();
  }
  return "accepted";
}

TEST(CertifiedGroup, RefusesWhatIsNoCollision) {
  GroupInput again = chain(1);
  again.collisions.push_back({0, 2, false, 1});
  EXPECT_NE(refusal(again).find("/collisions/2: bodies 0 and 2 are in one group"), std::string::npos);

  GroupInput walls = chain(1);
  walls.bodies[0].mass = walls.bodies[1].mass = HUGE_VAL;
  EXPECT_NE(refusal(walls).find("both of infinite mass"), std::string::npos);

  GroupInput point = chain(1);
  point.bodies[1].position = {0, 0};
  EXPECT_NE(refusal(point).find("at one point"), std::string::npos);

  GroupInput separating = chain(1);
  separating.bodies[0].velocity = {-1, 0};
  EXPECT_NE(refusal(separating).find("separate at an inner limit"), std::string::npos);

  GroupInput approaching = chain(1);
  approaching.collisions[0] = {0, 1, true, 0, 1, 1, 45};
  EXPECT_NE(refusal(approaching).find("approach at an outer limit"), std::string::npos);
}

}  // namespace
}  // namespace tps::certified
