// Same scene, same bytes; times that lose nothing (semantics §6).
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/ring.hpp"

namespace tps {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using testing::options_for;
using testing::traced;
using testing::traced_bytes;
using testing::TracedEvent;
using testing::TracedRun;

Rational exact(const std::string& hex) {
  const std::optional<HexDigits> digits = split_hex(hex);
  boost::multiprecision::cpp_int numerator = 0;
  for (const char c : digits->digits) numerator = numerator * 16 + (c <= '9' ? c - '0' : c - 'a' + 10);
  Rational value(numerator);
  const boost::multiprecision::cpp_int power = boost::multiprecision::cpp_int(1)
                                               << static_cast<unsigned long>(std::labs(digits->exponent));
  value = digits->exponent < 0 ? Rational(value / power) : Rational(value * power);
  return digits->negative ? Rational(-value) : value;
}

TEST(Determinism, TheSameBytesTwice) {
  for (const char* scalar : {"double", "float"}) {
    const Scene scene = build_ring({});
    const std::string first = traced_bytes(scene, options_for(scalar));
    EXPECT_EQ(first, traced_bytes(scene, options_for(scalar)));
    EXPECT_GT(first.size(), 10000U);
  }
}

TEST(Determinism, TheOrderOfParticlesInTheFileDoesNotMatter) {
  const auto scene_with = [](const std::string& particles) {
    return read_scene_text(
        R"({"tps":1,"dimension":2,"duration":9,"species":{"p":{"mass":1,"radius":0.5},"q":{"mass":2,"radius":0.25}},
            "pairs":[{"between":["p","p"],"blocking":{"c_rebound":0.9}},{"between":["p","q"],"blocking":{"c_rebound":1}}],
            "tethers":[],"particles":[)" +
            particles + "]}",
        "test");
  };
  const std::string a = R"({"id":5,"species":"p","position":[0,0],"velocity":[1,0.125]})";
  const std::string b = R"({"id":2,"species":"q","position":[2,0],"velocity":[-1,0]})";
  const std::string c = R"({"id":9,"species":"p","position":[4,0.25],"velocity":[-2,0]})";
  const std::string d = R"({"id":1,"species":"p","position":[-3,0.25],"velocity":[2,0]})";
  const std::string sorted = traced_bytes(scene_with(d + "," + b + "," + a + "," + c), options_for("double"));
  EXPECT_EQ(sorted, traced_bytes(scene_with(a + "," + b + "," + c + "," + d), options_for("double")));
  EXPECT_EQ(sorted, traced_bytes(scene_with(c + "," + a + "," + d + "," + b), options_for("double")));
  EXPECT_GE(testing::events_of(sorted).size(), 3U);
}

TEST(Determinism, AStartAtTwoToTheFortyHasTheSameEvents) {
  Scene scene = build_gas({.particles = 20, .density = .5, .restitution = .9, .duration = 2});
  scene.grouping = Grouping{.001};
  const TracedRun at_zero = traced(scene, "double");
  scene.start_time = 0x1p+40;
  const TracedRun late = traced(scene, "double");
  ASSERT_EQ(at_zero.events.size(), late.events.size());
  ASSERT_GT(late.events.size(), 100U);
  for (std::size_t n = 0; n < late.events.size(); ++n) {
    const TracedEvent& a = at_zero.events[n];
    const TracedEvent& b = late.events[n];
    EXPECT_EQ(a.exact_dt, b.exact_dt);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(exact(a.exact_t) + Rational(0x1p+40), exact(b.exact_t));
    // The lines are the same from "dt" on.
    const std::string& line_a = at_zero.lines[n + 2];
    const std::string& line_b = late.lines[n + 2];
    EXPECT_EQ(line_a.substr(line_a.find("\"dt\"")), line_b.substr(line_b.find("\"dt\"")));
  }
}

TEST(Time, IsExactAndDtIsItsRoundedDifference) {
  for (const double start : {0., 0x1p+40}) {
    Scene scene = build_gas({.particles = 20, .density = .5, .restitution = .9, .duration = 2});
    scene.start_time = start;
    const TracedRun run = traced(scene, "double");
    Rational before(start);
    for (const TracedEvent& e : run.events) {
      const Rational now = exact(e.exact_t);
      EXPECT_EQ(Rational(now - before).convert_to<double>(), e.dt) << e.k;
      before = now;
    }
  }
}

}  // namespace
}  // namespace tps
