// Every claim of the paper, measured, holds; each is a test of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "verify/claims/claim.hpp"
#include "verify/claims/report.hpp"
#include "verify/claims/runs.hpp"
#include "verify/claims/three_on_a_line.hpp"

namespace tps::claims {
namespace {

/// The page's block of `tps claims NAME` is what the program prints; docs.pages leaves those that take
/// seconds to this, so that each claim is measured once.
void expect_on_the_page(const Claim& claim) {
  std::ifstream file(TPS_SOURCE_DIR "/docs/claims.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::string printed = std::regex_replace(claims_text({claim}), std::regex(" +\n"), "\n");
  EXPECT_NE(page.find("$ tps claims " + claim.name + "\n" + printed + "```"), std::string::npos)
      << "docs/claims.md has no block '$ tps claims " << claim.name << "' with what is printed now:\n"
      << printed;
}

/// Reports each figure that is not as expected.
void expect_to_hold(const Claim& claim, std::size_t figures) {
  EXPECT_EQ(claim.figures.size(), figures) << claim.name << ": a figure was dropped or added";
  for (const Figure& figure : claim.figures) {
    EXPECT_TRUE(figure.holds) << claim.name << ": " << figure.name << " is " << figure.measured
                              << ", expected " << figure.expected << " (" << figure.derivation << ")";
  }
  expect_on_the_page(claim);
}

const Figure& figure(const Claim& claim, const std::string& name) {
  const auto found = std::find_if(claim.figures.begin(), claim.figures.end(),
                                  [&](const Figure& f) { return f.name == name; });
  if (found == claim.figures.end()) throw std::out_of_range(claim.name + " has no figure " + name);
  return *found;
}

// The literals are the paper's, or those of the analysis in docs/claims.md: a change of both sides of a
// figure at once does not pass.

TEST(Claims, Collisions) {
  const Claim claim = collisions();
  expect_to_hold(claim, 14);
  EXPECT_EQ(figure(claim, "collisions, double").measured, "70");
  EXPECT_EQ(figure(claim, "final velocity of X, double").measured, "-0.000461285096");
  EXPECT_EQ(figure(claim, "final velocity of Y, mp50").measured, "0.722243048177");
  EXPECT_EQ(figure(claim, "final velocity of Z, mp50").measured, "0.999739042048");
  EXPECT_EQ(figure(claim, "collisions for m_Y = 1").measured, "2");
  EXPECT_EQ(figure(claim, "collisions for m_Y = 1e-06").measured, "2221");
}

TEST(Claims, Stall) {
  const Claim claim = stall();
  expect_to_hold(claim, 25);
  EXPECT_EQ(figure(claim, "bound of collapse e_c").measured, "0.9144475");
  EXPECT_EQ(figure(claim, "collisions at c = 0.915, double").measured, "605");
  EXPECT_EQ(figure(claim, "collisions at c = 0.9145, mp50").measured, "1960");
  EXPECT_EQ(figure(claim, "collisions at c = 0.91445, 300 digits").measured, "8913");
}

// docs/claims.md tells of this run: it ends, on noise.
TEST(Claims, NearTheThresholdARunThatEndsMiscounts) {
  ThreeBodyParams params;
  params.restitution = 0.9147524902343749;
  EXPECT_EQ(count_or_stall(run_three_body(params)), "823");
  EXPECT_EQ(collisions_by_formula(params.middle_mass, params.restitution), 814);
}

TEST(Claims, Revolution) {
  const Claim claim = revolution();
  expect_to_hold(claim, 12);
  EXPECT_EQ(figure(claim, "time of event 2").measured, "1.681793");
  EXPECT_EQ(figure(claim, "time of event 5").measured, "8.888634");
  EXPECT_EQ(figure(claim, "speed after event 3").measured, "0.594604");
  EXPECT_EQ(figure(claim, "speed after event 5").measured, "0.420448");
}

TEST(Claims, Grouping) {
  const Claim claim = grouping();
  expect_to_hold(claim, 13);
  EXPECT_EQ(figure(claim, "collisions, c = 1").measured, "2");
  EXPECT_EQ(figure(claim, "velocity of Y, c = 0.9").measured, "0.949525237381");
}

TEST(Claims, Conservation) {
  expect_to_hold(conservation(), 6);
}

TEST(Claims, ClustersAndImpacts) {
  expect_to_hold(clusters(), 18);
  const Claim claim = impact();
  EXPECT_GE(claim.figures.size(), 3U * 6);
  expect_to_hold(claim, claim.figures.size());
}

TEST(Claims, EveryClaimIsListedOnce) {
  EXPECT_EQ(all_claims().size(), 7U);
}

TEST(Claims, AFigureThatIsNotAsExpectedFails) {
  EXPECT_FALSE(exactly("n", 70, "", 71).holds);
  EXPECT_FALSE(within("x", 1, 0.1, "", 1.2, 3).holds);
  EXPECT_FALSE(between("x", 0, 1, "", 1.2, 3).holds);
  EXPECT_FALSE(same("end", "stalled", "", "duration").holds);
  EXPECT_FALSE((Claim{"c", "", "", "", {exactly("n", 1, "", 1), exactly("n", 1, "", 2)}}.holds()));
  EXPECT_FALSE((Claim{"c", "", "", "", {}}.holds()));
}

}  // namespace
}  // namespace tps::claims
