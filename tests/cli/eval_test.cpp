// tps eval: what it prints, and what it says about input that it cannot use.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/shell.hpp"

namespace {

using tps::Outcome;
using tps::run_eval;

nlohmann::json out(const std::string& arguments) {
  const Outcome outcome = run_eval(arguments + " --format json");
  return outcome.exit_code == 0 ? nlohmann::json::parse(outcome.text)["out"] : nlohmann::json(outcome.text);
}

const std::string kPair = "u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 ";
const std::string kMasses = "m_A=1 m_B=1 ";

TEST(Eval, EveryOperationAnswers) {
  EXPECT_EQ(out("distance " + kPair + "dt=0"), (nlohmann::json{{"du", "0x1p+0"}}));
  EXPECT_EQ(out("paper_time u_A=0,0 u_B=5,0 v_A=1,0 v_B=0,0 L=1"), (nlohmann::json{{"t", "0x1p+2"}}));
  EXPECT_EQ(out("block_time u_A=0,0 u_B=5,0 v_A=1,0 v_B=0,0 L=1"),
            (nlohmann::json{{"verdict", "hit"}, {"t", "0x1p+2"}}));
  EXPECT_EQ(out("tether_time " + kPair + "L=1"), (nlohmann::json{{"verdict", "taut"}, {"t", "0x0p+0"}}));
  EXPECT_EQ(out("apply_impulse " + kMasses + "v_A=0,0 v_B=0,0 dp=1,2")["v_B"],
            (nlohmann::json{"-0x1p+0", "-0x1p+1"}));
  EXPECT_EQ(out("collision_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=-2,0 c=1 " + kMasses)["dp"][0], "-0x1p+1");
  EXPECT_EQ(out("revolution_impulse " + kPair + kMasses + "c_revolve=0 theta_revolve_deg=45")["dp"][1],
            "0x1p-1");
  EXPECT_EQ(
      out("tether_response " + kPair + kMasses + "c_retract=1 c_revolve=1 theta_revolve_deg=45")["kind"],
      "revolve");
  EXPECT_EQ(out("load m_A=inf m_B=1 v_A=1,0 v_B=0,0")["v_load"][0], "0x1p+0");
  EXPECT_EQ(out("restitution_impulse " + kMasses + "v_A=0,0 v_B=2,0 dp=0,0")["dp_AB"][0], "-0x1p+0");
}

TEST(Eval, EffectsAnswer) {
  EXPECT_EQ(out("wall_time u_A=0,0 u_B=3,1 v_A=0,0 v_B=-1,2 L=1 normal=1,0"),
            (nlohmann::json{{"verdict", "hit"}, {"t", "0x1p+1"}}));
  EXPECT_EQ(out("drag_time gamma=1 s=1"), (nlohmann::json{{"verdict", "never"}, {"t", nullptr}}));
  EXPECT_EQ(out("drag_time gamma=1 s=0.5")["t"], "0x1.62e42fefa39efp-1");  // ln 2
  // Perfectly rough discs (β₀ = 1) of equal masses: a spinning one gives a third of its spin's surface speed.
  const nlohmann::json rough = out("rough_impulse u_A=0,0 u_B=1,0 v_A=1,0 v_B=0,0 spin_A=3 spin_B=0 " +
                                   kMasses + "R_A=0.5 R_B=0.5 c=1 mu=9 beta0=1");
  EXPECT_EQ(rough["kind"], "sticks");
  EXPECT_EQ(rough["v_B"], (nlohmann::json{"0x1p+0", "0x1p-1"}));
  EXPECT_EQ(rough["spin_A"], "0x1p+0");
  EXPECT_EQ(rough["spin_B"], "-0x1p+1");
}

TEST(Eval, NoEventIsNull) {
  EXPECT_EQ(out("block_time " + kPair + "L=1"), (nlohmann::json{{"verdict", "receding"}, {"t", nullptr}}));
}

// A decimal is the nearest double in every scalar; wider ones compute on that double.
TEST(Eval, DecimalsAreDoublesInEveryScalar) {
  for (const char* scalar : {"double", "long-double", "quad", "mp50", "mp100"}) {
    EXPECT_EQ(out("distance u_A=0,0 u_B=0.1,0 v_A=0,0 v_B=0,0 dt=0 --scalar " + std::string(scalar))["du"],
              "0x1.999999999999ap-4")
        << scalar;
  }
  EXPECT_EQ(out("distance u_A=0,0 u_B=0.1,0 v_A=0,0 v_B=0,0 dt=0 --scalar float")["du"], "0x1.99999ap-4");
}

TEST(Eval, ReadsTheObjectOfTheProtocol) {
  const std::string in = R"({"m_A":"0x1p+0","m_B":3,"v_A":[4,8,0],"v_B":[0,0,"0x0p+0"]})";
  const std::string answer = R"("out":{"v_load":["0x1p+0","0x1p+1","0x0p+0"]})";
  EXPECT_NE(run_eval("load --in - --format json", in).text.find(answer), std::string::npos);
  const std::string request = R"({"seq":1,"op":"load","in":)" + in + "}";
  EXPECT_NE(run_eval("load --in - --format json", request).text.find(answer), std::string::npos);
  EXPECT_EQ(run_eval("distance --in -", request).exit_code, 3);
}

struct Refused {
  const char* arguments;
  int exit_code;
  const char* says;
};

TEST(Eval, SaysWhatIsWrong) {
  const Refused cases[] = {
      {"blok_time", 2, "did you mean block_time?"},
      {"load --scalar half", 2, "half"},
      {"load m_A=1 m_B=1 v_A=1,0 v_B=0,0 --in -", 2, "--in"},
      {"load m_A=1 mB=1 v_A=1,0 v_B=0,0", 3, "load has no key mB; did you mean m_B?"},
      {"load m_A=1 v_A=1,0 v_B=0,0", 3, "load needs m_B"},
      {"load m_A=1 m_A=1 m_B=1 v_A=1,0 v_B=0,0", 3, "m_A is given twice"},
      {"load m_A m_B=1 v_A=1,0 v_B=0,0", 3, "'m_A' is not key=value"},
      {"load m_A=0 m_B=1 v_A=1,0 v_B=0,0", 3, "m_A is 0; a mass must be above 0, or inf"},
      {"load m_A=inf m_B=inf v_A=1,0 v_B=0,0", 3, "both inf"},
      {"load m_A=1 m_B=1 v_A=1,0 v_B=0,0,0", 3, "v_B has 3 components where the vectors before it have 2"},
      {"load m_A=1 m_B=1 v_A=1 v_B=0,0", 3, "v_A has 1 components; a vector has 2 or 3"},
      {"load m_A=1 m_B=1 v_A=nan,0 v_B=0,0", 3, "'nan' is not a number"},
      {"load m_A=1 m_B=1 v_A=inf,0 v_B=0,0", 3, "components must be finite"},
      {"load m_A=1 m_B=1 v_A=1e400,0 v_B=0,0", 3, "outside the range of double"},
      {"load m_A=1e-400 m_B=1 v_A=1,0 v_B=0,0", 3, "m_A is 0; a mass must be above 0, or inf"},
      {"order first.kind=blok", 3, "first.kind is blok; write first.kind=block or first.kind=tether"},
      {"order first.kind=block first.u_A=0,0", 3, "first: block_time needs u_B"},
      {"load m_A=1 m_B=1 v_A=0x1.00000000000001p+0,0 v_B=0,0", 3, "no double has"},
      {"load m_A=1e300 m_B=1 v_A=1,0 v_B=0,0 --scalar float", 3, "outside the range of float"},
      {"block_time u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 L=0", 3,
       "L is 0; a limiting distance must be finite and above 0"},
      {"collision_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 m_A=1 m_B=1 c=2", 3,
       "c is 2; a coefficient must be in [0, 1]"},
      {"collision_impulse u_A=1,0 u_B=1,0 v_A=0,0 v_B=0,1 m_A=1 m_B=1 c=1", 3,
       "u_A and u_B are the same point"},
      {"revolution_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 m_A=1 m_B=1 c_revolve=1 theta_revolve_deg=90", 3,
       "θ_revolve must be in"},
      {"revolution_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=1,0 m_A=1 m_B=1 c_revolve=1 theta_revolve_deg=45", 3,
       "û_revolve is 0/0"},
      {"wall_time u_A=0,0 u_B=3,1 v_A=0,0 v_B=-1,2 L=1 normal=1,1", 3,
       "normal has the length 1.4142135623730951; a direction has length 1, to 2^-10"},
      {"wall_time u_A=0,0 u_B=3,1 v_A=0,0 v_B=-1,2 L=1 normal=1,0,0", 3,
       "normal has 3 components where the vectors before it have 2"},
      {"drag_time gamma=0 s=1", 3, "gamma is 0; a rate must be finite and above 0"},
      {"drag_time gamma=1 s=-1", 3, "s is -1; it must be finite and at least 0"},
      {"rough_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 spin_A=1,2 spin_B=0 m_A=1 m_B=1 R_A=0 R_B=1 c=1 mu=-1 "
       "beta0=2",
       3, "R_A is 0; a radius must be finite and above 0"},
      {"rough_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 spin_A=1 spin_B=0 m_A=1 m_B=1 R_A=1 R_B=1 c=1 mu=-1 "
       "beta0=2",
       3, "mu is -1; it must be finite and at least 0"},
      {"rough_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 spin_A=1 spin_B=0 m_A=1 m_B=1 R_A=1 R_B=1 c=1 mu=1 "
       "beta0=2",
       3, "beta0 is 2; tangential restitution must be in [-1, 1]"},
      {"rough_impulse u_A=0,0 u_B=1,0 v_A=0,0 v_B=0,1 spin_A=1,2 spin_B=0 m_A=1 m_B=1 R_A=1 R_B=1 c=1 mu=1 "
       "beta0=1",
       3, "spin_A has 2 components; a spin is one number in the plane, three in space"},
  };
  for (const Refused& refused : cases) {
    const Outcome outcome = run_eval(refused.arguments);
    EXPECT_EQ(outcome.exit_code, refused.exit_code) << refused.arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(refused.says), std::string::npos) << refused.arguments << "\n"
                                                                  << outcome.text;
  }
}

TEST(Eval, NamesThePlaceInAFile) {
  const Outcome outcome = run_eval("load --in -", "{\"m_A\":1,\n\"m_B\":true,\n\"v_A\":[1,0],\"v_B\":[0,0]}");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.text.find("standard input:2: /m_B: must be a number"), std::string::npos) << outcome.text;
}

}  // namespace
