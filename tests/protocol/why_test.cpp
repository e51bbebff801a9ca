// tps eval with operations of the protocol, and --why.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "reference/text/hexfloat.hpp"
#include "tests/support/shell.hpp"

namespace {

using tps::Outcome;
using tps::run_eval;

nlohmann::json result(const std::string& arguments) {
  const Outcome evaluated = run_eval(arguments + " --format json");
  if (evaluated.exit_code != 0) return evaluated.text;
  return nlohmann::json::parse(evaluated.text);
}

std::string query(const std::string& u_B, const std::string& prefix = "") {
  return prefix + "u_A=0,0 " + prefix + "u_B=" + u_B + " " + prefix + "v_A=0,0 " + prefix + "v_B=1,0 " +
         prefix;
}

TEST(Why, NamesTheStageThatSettledTheVerdict) {
  EXPECT_EQ(result("block_time --why " + query("-5,0") + "L=1")["out"]["verdict_by"], "doubles");
  const nlohmann::json grazing = result("block_time --why " + query("-10000,0x1.00000004p+0") + "L=1");
  EXPECT_EQ(grazing["out"]["verdict"], "miss");
  EXPECT_EQ(grazing["out"]["verdict_by"], "double words");
  EXPECT_EQ(grazing["out"]["verdict_counts"], "calls 1, uncertain 1, exact 0");
  EXPECT_TRUE(grazing["steps"].contains("double_words_D_bound"));
  EXPECT_FALSE(grazing["steps"].contains("integers"));
  const nlohmann::json tangent = result("block_time --why " + query("-5,1") + "L=1");
  EXPECT_EQ(tangent["out"]["verdict_by"], "integers");
  EXPECT_EQ(tangent["steps"]["integers"], "h negative, c positive, D zero");
  EXPECT_NE(tangent["out"]["largest_bits"], "0");
  EXPECT_EQ(result("block_time --why u_A=0,0 u_B=5,0 v_A=1,1 v_B=1,1 L=1")["out"]["verdict_by"],
            "equal velocities");
  EXPECT_EQ(result("block_time --why " + query("-1e300,0") + "L=1")["steps"]["doubles"], "out of range");
}

// r·v and r·r − L² of integers: what is told is the exact number to the bound that is told.
TEST(Why, DoubleWordsAreToldToTheirBounds) {
  using Integer = boost::multiprecision::cpp_int;
  const auto exactly = [](const nlohmann::json& text) {  // in units of 2^-300
    const auto number = tps::split_hex(text.get<std::string>()).value();
    const Integer digits = Integer("0x0" + number.digits) << static_cast<unsigned>(number.exponent + 300);
    return number.negative ? Integer(-digits) : digits;
  };
  const Integer x("0x123456789abd"), y("0xfedcba987654"), v("0x1000000000001");
  const nlohmann::json steps = result(
      "block_time --why u_A=0,0 u_B=-20015998343869,280223976814164 v_A=0,0 v_B=281474976710657,1 "
      "L=280223976814164")["steps"];
  const auto told = [&](const std::string& name, const Integer& true_value) {
    const std::string key = "double_words_" + name;
    ASSERT_TRUE(steps.contains(key)) << steps;
    const Integer off = exactly(steps[key]) + exactly(steps[key + "_lower"]) - (true_value << 300U);
    EXPECT_LE(abs(off), exactly(steps[key + "_bound"])) << name;
    if (name == "a") return;  // the bound is that of doubles
    const Integer off_alone = exactly(steps[key]) - (true_value << 300U);
    EXPECT_GT(abs(off_alone), exactly(steps[key + "_bound"])) << name << ": the case says nothing";
  };
  told("a", v * v + 1);
  told("h", y - x * v);
  told("c", x * x);
}

// The equations in double have no answer: the differences are beyond its range.
TEST(Why, AnswersWhatDoublesCannot) {
  const nlohmann::json far = result("block_time --why u_A=-1.7e308,0 u_B=1.7e308,0 v_A=1,0 v_B=-1,0 L=1");
  EXPECT_EQ(far["out"]["verdict"], "hit");
  EXPECT_EQ(far["out"]["verdict_by"], "integers");
  EXPECT_EQ(far["out"]["t"], "0x1.e42d130773b76p+1023");  // 1.7e308 − 1/2
  EXPECT_EQ(far["out"]["verdict_in_double"], "beyond its range");
  EXPECT_EQ(far["out"]["t_in_double"], nullptr);
}

// Found by search: the double answer of this query is one ulp below the correctly rounded one.
TEST(Why, CountsTheUlpsOfTheDoubleAnswer) {
  const nlohmann::json off = result("tether_time --why u_A=0,0 u_B=0.3,0.1 v_A=0.7,0.1 v_B=0.2,-0.3 L=1");
  EXPECT_EQ(off["out"]["ulps"], "-1");
  EXPECT_EQ(off["out"]["t"], "0x1.020577c909b61p+1");
  EXPECT_EQ(off["out"]["t_in_double"], "0x1.020577c909b6p+1");
  EXPECT_EQ(result("block_time --why " + query("-5,0") + "L=1")["out"]["ulps"],
            "0, the correctly rounded one");
}

TEST(Why, OrdersTellTheirStage) {
  const std::string tie = "first.kind=block " + query("-10,3", "first.") + "L=5 second.kind=block ";
  const nlohmann::json equal = result("order --why " + tie + query("-11,0", "second.") + "L=5");
  EXPECT_EQ(equal["out"]["order"], "equal");
  EXPECT_EQ(equal["out"]["order_by"], "integers");
  const nlohmann::json near =
      result("order --why " + tie + query("-11.0000000000000018,0", "second.") + "L=5");
  EXPECT_EQ(near["out"]["order"], "before");
  EXPECT_EQ(near["out"]["order_by"], "double words");
  EXPECT_EQ(result("order " + tie + query("-12,0", "second.") + "L=5")["out"]["order"], "before");
}

TEST(EvalCompound, TakesAFileOrARequest) {
  const std::string in =
      R"({"bodies":[{"m":1,"u":[0,0],"v":[1,0]},{"m":1,"u":[1,0],"v":[0,0]}],"collisions":[{"i":0,"j":1,"limit":"inner","c":1}]})";
  EXPECT_NE(run_eval("group --in -", in).text.find("> restituted[1] = (1, 0)"), std::string::npos);
  const std::string request = R"({"seq":1,"op":"group","in":)" + in + "}";
  EXPECT_NE(run_eval("group --in - --format json", request).text.find(R"("out":{"loaded":)"),
            std::string::npos);
  EXPECT_EQ(run_eval("order --in -", request).exit_code, 3);
}

TEST(EvalCompound, SaysWhatIsWrong) {
  EXPECT_EQ(run_eval("group").exit_code, 2);
  EXPECT_EQ(run_eval("order --scalar quad").exit_code, 2);
  EXPECT_EQ(run_eval("load --why m_A=1 m_B=1 v_A=0,0 v_B=0,0").exit_code, 2);
  EXPECT_EQ(run_eval("block_time --scalar quad --why " + query("-5,0") + "L=1").exit_code, 2);
  EXPECT_EQ(run_eval("group --why --in -", "{}").exit_code, 2);
  const Outcome words = run_eval("order first.kind=block u_A=0,0");
  EXPECT_EQ(words.exit_code, 3);
  EXPECT_NE(words.text.find("'u_A=0,0' is neither"), std::string::npos);
  EXPECT_NE(run_eval("order first.u_A=0,0").text.find("first.kind is missing"), std::string::npos);
  EXPECT_NE(run_eval("group --in -", "{\"bodies\":[]}").text.find("needs the key collisions"),
            std::string::npos);
}

}  // namespace
