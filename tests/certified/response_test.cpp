// Certified responses against the reference's equations in 100 digits, and against results known by hand.
#include "verify/certified/certified_response.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "verify/operations/domain.hpp"
#include "verify/operations/evaluate.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::certified {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : bits_(seed) {}

  double uniform(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(bits_); }
  std::vector<double> vector(int dimension) {
    std::vector<double> v;
    for (int k = 0; k < dimension; ++k) v.push_back(std::ldexp(uniform(-1, 1), pick(-20, 20)));
    return v;
  }
  int pick(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(bits_); }

  operations::Input input(const operations::Operation& operation) {
    operations::Input in;
    in.dimension = pick(2, 3);
    for (const std::string& key : operation.keys) {
      switch (operations::domain_of(key)) {
        case operations::Domain::vector:
          in.values[key] = vector(in.dimension);
          break;
        case operations::Domain::mass:
          in.values[key] = {key == "m_B" && pick(0, 4) == 0 ? HUGE_VAL
                                                            : std::ldexp(uniform(1, 2), pick(-20, 20))};
          break;
        case operations::Domain::spin:
          in.values[key] = vector(in.dimension == 2 ? 1 : 3);
          break;
        case operations::Domain::angle:
          in.values[key] = {pick(0, 1) == 0 ? uniform(1e-6, 89.99) : pick(1, 5) * 15.0};
          break;
        default:
          in.values[key] = {pick(0, 4) == 0 ? 1.0 : uniform(0, 1)};
      }
    }
    return in;
  }

 private:
  std::mt19937_64 bits_;
};

const char* const kOperations[] = {
    "apply_impulse", "collision_impulse",   "revolution_impulse", "tether_response",
    "load",          "restitution_impulse", "rough_impulse"};

bool tight(const Enclosure& e) {
  const double next = std::nextafter(e.lo, HUGE_VAL);
  return e.lo == e.hi || e.hi == next || (e.hi == std::nextafter(next, HUGE_VAL) && e.nearest == next);
}

// The reference forms û and the tangential part by roots and differences, the certified answer by fractions:
// they share no formula. Cancellation costs the reference fewer than 40 of its 100 digits on these inputs.
TEST(CertifiedResponse, EnclosesTheReferenceIn100Digits) {
  Generator generator(20);
  int components = 0;
  for (int n = 0; n < 1050; ++n) {
    const operations::Operation& operation = *operations::find(kOperations[n % 7]);
    const operations::Input input = generator.input(operation);
    const Response response = certified_response(operation.op, input);
    for (const operations::Quantity& q : operations::evaluate(operation, input, "mp100").results) {
      if (!q.word.empty()) {
        EXPECT_EQ(response.kind, q.word);
        continue;
      }
      const EnclosedVector& enclosed = response.values.at(q.key);
      ASSERT_EQ(enclosed.size(), q.numbers.size());
      for (std::size_t k = 0; k < enclosed.size(); ++k) {
        const Enclosure& e = enclosed[k];
        const Wide value = *from_hex<Wide>(q.numbers[k].hex);
        const Wide margin = Wide("1e-60") * (abs(value) + Wide(1e-40));
        EXPECT_LE(Wide(e.lo), value + margin) << operation.name << " " << q.key;
        EXPECT_GE(Wide(e.hi), value - margin) << operation.name << " " << q.key;
        EXPECT_EQ(e.nearest, static_cast<double>(value)) << operation.name << " " << q.key;
        EXPECT_TRUE(tight(e)) << operation.name << " " << q.key;
        EXPECT_TRUE(e.settled);
        ++components;
      }
    }
  }
  EXPECT_GT(components, 2000);
}

Response respond(const char* name, const std::vector<std::string>& words) {
  const operations::Operation& operation = *operations::find(name);
  return certified_response(operation.op, operations::read_words(operation, words));
}

void expect_double(const Enclosure& e, double x) {
  EXPECT_EQ(e.lo, x);
  EXPECT_EQ(e.hi, x);
  EXPECT_EQ(e.nearest, x);
}

// û = (3, 4)/5 is no pair of doubles; the impulse is.
TEST(CertifiedResponse, RationalImpulsesAreExact) {
  const Response r =
      respond("collision_impulse", {"u_A=0,0", "u_B=3,4", "v_A=0,0", "v_B=-25,0", "m_A=1", "m_B=1", "c=1"});
  expect_double(r.values.at("dp")[0], -9);
  expect_double(r.values.at("dp")[1], -12);
}

// θ = 45°, c_revolve = 1/4, û = (1, 1)/√2: every root is rational, and v_AB' = (−1, 0) exactly.
TEST(CertifiedResponse, ARevolutionWithRationalRootsIsExact) {
  const Response r = respond("revolution_impulse", {"u_A=0,0", "u_B=1,1", "v_A=0,0", "v_B=-1,1", "m_A=1",
                                                    "m_B=1", "c_revolve=0.25", "theta_revolve_deg=45"});
  expect_double(r.values.at("dp")[0], 0);
  expect_double(r.values.at("dp")[1], 0.5);
}

// Speeds of an isolated revolving pair (docs/oracles.md): 0.5^(1/4) after the first event.
TEST(CertifiedResponse, RevolutionKeepsTheRatioOfSpeeds) {
  const Response r =
      respond("tether_response", {"u_A=0,0", "u_B=1,0", "v_A=0,0", "v_B=0,1", "m_A=inf", "m_B=1",
                                  "c_retract=0.5", "c_revolve=0.5", "theta_revolve_deg=45"});
  EXPECT_EQ(r.kind, "revolve");
  EXPECT_FALSE(r.boundary);
  const double v_x = r.values.at("v_B")[0].nearest;
  const double v_y = r.values.at("v_B")[1].nearest;
  EXPECT_EQ(v_x, -v_y);
  EXPECT_EQ(v_y, std::pow(2.0, -0.75));
  expect_double(r.values.at("v_A")[0], 0);
}

// |c v_n| against tan θ |v_ŵ|, decided exactly: at 45° both are 1, at 30° and 60° tan² is 1/3 and 3.
TEST(CertifiedResponse, TheBoundaryBetweenRetractionAndRevolutionIsExact) {
  const auto kind_of = [](const std::string& v_B, const std::string& c_retract, const std::string& theta) {
    return respond("tether_response",
                   {"u_A=0,0", "u_B=1,0", "v_A=0,0", "v_B=" + v_B, "m_A=1", "m_B=1", "c_retract=" + c_retract,
                    "c_revolve=1", "theta_revolve_deg=" + theta});
  };
  EXPECT_TRUE(kind_of("1,1", "1", "45").boundary);
  EXPECT_EQ(kind_of("1,1", "1", "45").kind, "revolve");
  EXPECT_EQ(kind_of("0x1.0000000000001p+0,1", "1", "45").kind, "retract");
  EXPECT_FALSE(kind_of("0x1.0000000000001p+0,1", "1", "45").boundary);
  EXPECT_EQ(kind_of("0x1.fffffffffffffp-1,1", "1", "45").kind, "revolve");
  EXPECT_FALSE(kind_of("0x1.fffffffffffffp-1,1", "1", "45").boundary);
  EXPECT_FALSE(kind_of("1,1", "1", "44.999999999999993").boundary);
  EXPECT_EQ(kind_of("1,1", "1", "44.999999999999993").kind, "retract");
  // Without tangential motion a retraction; with c_retract = 0 rounding decides.
  EXPECT_EQ(kind_of("1,0", "0.5", "45").kind, "retract");
  EXPECT_FALSE(kind_of("1,0", "0.5", "45").boundary);
  EXPECT_EQ(kind_of("1,0", "0", "45").kind, "retract");
  EXPECT_TRUE(kind_of("1,0", "0", "45").boundary);
}

// û = (3, 4)/5; both limits of friction are equal: 0.75 · 1.5 |v_n| = 1/3 · 1.5 |g_t| with v_n = −4, g_t = 9.
TEST(CertifiedResponse, TheBoundaryBetweenHoldingAndSlidingIsExact) {
  const auto kind_of = [](const std::string& v_B) {
    return respond("rough_impulse", {"u_A=0,0", "u_B=3,4", "v_A=0,0", "v_B=" + v_B, "spin_A=1", "spin_B=0",
                                     "m_A=1", "m_B=1", "R_A=1", "R_B=1", "c=0.5", "mu=0.75", "beta0=0.5"});
  };
  // v = −4 û + 10 t̂, t̂ = (−4, 3)/5; the surface of A moves with 1 t̂.
  const Response equal = kind_of("-10.4,2.8");
  EXPECT_FALSE(equal.boundary);  // decimals are not the numbers meant
  const Response exactly =
      respond("rough_impulse", {"u_A=0,0", "u_B=1,0", "v_A=0,0", "v_B=-4,10", "spin_A=1", "spin_B=0", "m_A=1",
                                "m_B=1", "R_A=1", "R_B=1", "c=0.5", "mu=0.75", "beta0=0.5"});
  EXPECT_TRUE(exactly.boundary);
  EXPECT_EQ(exactly.kind, "sticks");
  expect_double(exactly.values.at("dp")[1], 2.25);
}

TEST(CertifiedResponse, InfiniteMassesAndTheEndsOfTheRange) {
  const Response wall = respond("load", {"m_A=inf", "m_B=5e-324", "v_A=1,0", "v_B=1e308,0"});
  expect_double(wall.values.at("v_load")[0], 1);
  const Response light =
      respond("apply_impulse", {"m_A=5e-324", "m_B=1e300", "v_A=0,1", "v_B=0,0", "dp=1,5e-324"});
  EXPECT_EQ(light.values.at("v_A")[0].nearest, HUGE_VAL);
  expect_double(light.values.at("v_A")[1], 2);
  EXPECT_EQ(light.values.at("v_B")[1].nearest, 0);
  EXPECT_EQ(light.values.at("v_B")[1].lo, -5e-324);
}

TEST(CertifiedResponse, EquationFiveNeedsTangentialMotion) {
  const std::vector<std::string> radial = {"u_A=0,0", "u_B=1,3", "v_A=0,0",     "v_B=2,6",
                                           "m_A=1",   "m_B=1",   "c_revolve=1", "theta_revolve_deg=45"};
  EXPECT_THROW(respond("revolution_impulse", radial), operations::NoAnswer);
}

}  // namespace
}  // namespace tps::certified
