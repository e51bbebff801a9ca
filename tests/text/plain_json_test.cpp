// The one strict reader, for documents of which no tree of ours is made.
#include "reference/text/plain_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "reference/text/input_error.hpp"
#include "tests/support/processor_time.hpp"

namespace tps {
namespace {

using Json = nlohmann::ordered_json;

std::string refusal(const std::string& text) {
  try {
    parse_plain_json(text, "f");
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PlainJson, KeepsIntegersOfSixtyFourBitsAndTheOrderOfKeys) {
  const Json value =
      parse_plain_json(R"({"z":18446744073709551615,"a":-9223372036854775808,"m":[1,-0,0.5]})", "f");
  EXPECT_EQ(value.dump(), R"({"z":18446744073709551615,"a":-9223372036854775808,"m":[1,-0.0,0.5]})");
  EXPECT_EQ(value["z"].get<std::uint64_t>(), UINT64_MAX);
  EXPECT_EQ(value["a"].get<std::int64_t>(), INT64_MIN);
}

TEST(PlainJson, RefusesWhatOtherReadersLetThrough) {
  EXPECT_EQ(refusal(R"({"a":1,"b":{"c":1,"c":2}})"),
            R"(f:1: /b: key "c" stands twice, here and in line 1; keep one)");
  EXPECT_NE(refusal(std::string("{}\0garbage", 10)).find("NUL"), std::string::npos);
  EXPECT_NE(refusal("{} {}").find("not JSON"), std::string::npos);
  EXPECT_NE(refusal("\xEF\xBB\xBF{}").find("byte order mark"), std::string::npos);
  EXPECT_NE(refusal("[NaN]").find("found NaN"), std::string::npos);
  EXPECT_NE(refusal("[1e400]").find("beyond the largest double"), std::string::npos);
  EXPECT_NE(refusal("[\"\xff\"]").find("not JSON"), std::string::npos);
}

TEST(PlainJson, DepthAndKeysAreBounded) {
  for (const char* open : {"[", "{\"a\":", "[[],"}) {
    std::string deep;
    for (int n = 0; n < 200'000; ++n) deep += open;
    EXPECT_NE(refusal(deep).find("more than 64 deep"), std::string::npos) << open;
  }
  const std::string text = refusal("{\"" + std::string(1'000'000, 'k') + "\":[1,2]}");
  EXPECT_NE(text.find("a key of 1000000 bytes"), std::string::npos) << text;
  EXPECT_LT(text.size(), 300U);
}

TEST(PlainJson, AHundredThousandKeysTakeNoTime) {
  std::string text = "{";
  for (int n = 0; n < 100'000; ++n) text += "\"k" + std::to_string(n) + "\":0,";
  text.back() = '}';
  const double start = processor_seconds();
  EXPECT_EQ(parse_plain_json(text, "f").size(), 100'000U);
  EXPECT_LT(processor_seconds() - start, 10);
}

}  // namespace
}  // namespace tps
