// Replies of other people's programs as answers of a variant.
#include "properties/cost/foreign_variant.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/implementations/program.hpp"

namespace tps::properties {
namespace {

double value_of(const cost::ExactNumber& number) {
  double sum = 0;
  for (const double part : number.parts) sum += part;
  return std::ldexp(sum, number.exponent);
}

TEST(ForeignNumbers, AreHexadecimalFloatsOrJsonNumbers) {
  EXPECT_EQ(value_of(exact_number_of("0x1.8p+1")), 3);
  EXPECT_EQ(value_of(exact_number_of("0x.8p0")), 0.5);
  EXPECT_EQ(value_of(exact_number_of("-0x1.8p-3")), -0.1875) << "wrong, and a number";
  EXPECT_EQ(value_of(exact_number_of(-0.5)), -0.5);
  EXPECT_EQ(value_of(exact_number_of("0xAp-1")), 5);
  EXPECT_EQ(value_of(exact_number_of("0x1p-1074")), 0x1p-1074);
  EXPECT_EQ(value_of(exact_number_of(0.1)), 0.1);
}

/// 1 + 2^-200 has 51 digits: the last is the one that a double loses.
TEST(ForeignNumbers, KeepDigitsBeyondADouble) {
  const cost::ExactNumber number = exact_number_of("0x1." + std::string(49, '0') + "1p+0");
  EXPECT_EQ(std::ldexp(number.parts[0], number.exponent), 1);
  double rest = 0;
  for (std::size_t k = 1; k < number.parts.size(); ++k) rest += number.parts[k];
  EXPECT_EQ(std::ldexp(rest, number.exponent), 0x1p-200);
}

TEST(ForeignNumbers, AreNothingElse) {
  for (const Json& bad : {Json("1.5"), Json("0x"), Json("0x1p"), Json("0x1p99999999999"), Json("0x3"),
                          Json("--0x1p+0"), Json("0x1.8q2"), Json("0x1p+1z"), Json(nullptr), Json(true)}) {
    EXPECT_THROW(exact_number_of(bad), ProgramError) << bad;
  }
}

TEST(ForeignAnswers, AreEventsTimesAndRefusals) {
  const auto reply = [](Json out) { return answer_of(Answer{Answer::Status::answered, std::move(out), {}}); };
  const cost::Answer hit = reply({{"verdict", "hit"}, {"t", "0x1p+2"}});
  EXPECT_TRUE(hit.occurs && hit.t && !hit.at_once);
  EXPECT_EQ(hit.verdict, TimingVerdict::hit);
  EXPECT_TRUE(reply({{"verdict", "contact"}, {"t", 0}}).at_once);
  EXPECT_FALSE(reply({{"verdict", "miss"}, {"t", nullptr}}).occurs);
  EXPECT_FALSE(reply({{"t", "inf"}}).t);
  EXPECT_TRUE(reply({{"t", "inf"}}).occurs);
  EXPECT_FALSE(answer_of({Answer::Status::refused, {}, "0/0"}).occurs);
  EXPECT_THROW(answer_of({Answer::Status::failed, {}, "crashed"}), ProgramError);
  EXPECT_THROW(reply({{"verdict", "hit"}}), ProgramError);
}

}  // namespace
}  // namespace tps::properties
