// The interpreter of schemas on its own, on schemas made for the purpose.
#include "reference/text/schema_validator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reference/text/input_error.hpp"
#include "reference/text/nearest_name.hpp"

namespace tps {
namespace {

// Every problem of a text by a schema, one a line; empty if it is accepted.
std::string problems(const std::string& schema, const std::string& text) {
  JsonDocument document = parse_json(text, "f");
  Schema(schema, "schema").validate(document.root, document.problems);
  std::string all;
  for (const InputProblem& problem : document.problems.problems()) all += format_problem(problem) + "\n";
  return all;
}

TEST(Schema, JudgesTypes) {
  const std::string schema = R"({"type": ["integer", "null"]})";
  EXPECT_EQ(problems(schema, "3"), "");
  EXPECT_EQ(problems(schema, "3.0"), "") << "an integer is a number without fraction, however it is written";
  EXPECT_EQ(problems(schema, "null"), "");
  EXPECT_EQ(problems(schema, "3.5"), "f:1: found 3.5; allowed: an integer or null\n");
  EXPECT_EQ(problems(schema, "true"), "f:1: found true; allowed: an integer or null\n");
}

TEST(Schema, JudgesBounds) {
  const std::string schema = R"({"type": "number", "exclusiveMinimum": 0, "maximum": 1})";
  EXPECT_EQ(problems(schema, "1"), "");
  EXPECT_EQ(problems(schema, "0"), "f:1: found 0; allowed: a number greater than 0 and of at most 1\n");
  EXPECT_EQ(problems(schema, "1.5"), "f:1: found 1.5; allowed: a number greater than 0 and of at most 1\n");
}

TEST(Schema, BoundsHoldForNumbersInStringsToo) {
  const std::string schema =
      R"({"type": ["number", "string"], "format": "tps-number", "exclusiveMaximum": 1})";
  EXPECT_EQ(problems(schema, "\"0x1p-1\""), "");
  EXPECT_EQ(
      problems(schema, "\"0x1p+0\""),
      "f:1: found \"0x1p+0\"; allowed: a number less than 1; a number in a string is a hexadecimal float "
      "like \"0x1.8p+1\"\n");
}

TEST(Schema, AddsWhatStandsBesideAReference) {
  const std::string schema = R"({"$ref": "#/$defs/n", "minimum": 2, "$defs": {"n": {"type": "number"}}})";
  EXPECT_EQ(problems(schema, "2"), "");
  EXPECT_EQ(problems(schema, "1"), "f:1: found 1; allowed: a number of at least 2\n");
  EXPECT_EQ(problems(schema, "[]"), "f:1: found a list of 0 entries; allowed: a number of at least 2\n");
}

TEST(Schema, ChoosesTheAlternativeThatWasMeant) {
  const std::string schema = R"({"oneOf": [{"enum": ["a", "b"]},
    {"type": "object", "required": ["p"], "properties": {"p": {"type": "number"}}, "additionalProperties": false},
    {"type": "object", "required": ["q"], "properties": {"q": {"type": "string"}}}]})";
  EXPECT_EQ(problems(schema, "\"b\""), "");
  EXPECT_EQ(problems(schema, "{\"p\": 1}"), "");
  EXPECT_EQ(problems(schema, "{\"p\": \"1\"}"), "f:1: /p: found \"1\"; allowed: a number\n");
  EXPECT_EQ(problems(schema, "{\"p\": 1, \"r\": 2}"),
            "f:1: unknown key \"r\"; the nearest known key is \"p\"; allowed: \"p\"\n");
  EXPECT_EQ(problems(schema, "\"c\""),
            "f:1: found \"c\"; allowed: \"a\", \"b\", an object with the key \"p\" or an object with the key "
            "\"q\"\n");
}

TEST(Schema, ReportsEveryProblemWithItsPlace) {
  const std::string schema = R"({"type": "object", "required": ["a", "b"], "additionalProperties": false,
    "properties": {"a": {"type": "array", "items": {"type": "boolean"}, "maxItems": 3}, "b": {"type": "string"}}})";
  EXPECT_EQ(problems(schema, "{\"a\": [true,\n1,\n2],\n\"c/d\": 1}"),
            "f:1: key \"b\" is missing; it holds a string\n"
            "f:2: /a/1: found 1; allowed: true or false\n"
            "f:3: /a/2: found 2; allowed: true or false\n"
            "f:4: unknown key \"c/d\"; the nearest known key is \"a\"; allowed: \"a\", \"b\"\n");
}

TEST(Schema, RefusesAKnownKeyWithTheReason) {
  const std::string schema =
      R"({"type": "object", "properties": {"g": {"not": {}, "description": "not yet"}}})";
  EXPECT_EQ(problems(schema, "{\"g\": 1}"), "f:1: /g: not yet\n");
}

TEST(Schema, CountsCharactersNotBytes) {
  const std::string schema = R"({"type": "string", "maxLength": 2})";
  EXPECT_EQ(problems(schema, "\"äö\""), "");
  EXPECT_EQ(problems(schema, "\"abc\""), "f:1: found \"abc\"; allowed: a string of at most 2 characters\n");
}

TEST(Schema, ItselfMustNotSayMoreThanIsInterpreted) {
  for (const char* schema : {R"({"uniqueItems": true})", R"({"properties": {"a": {"multipleOf": 2}}})",
                             R"({"items": {"format": "date"}})", R"({"type": "string", "pattern": "^a"})",
                             R"({"anyOf": [{"type": "string"}]})", R"({"not": {"type": "string"}})",
                             R"({"$ref": "#/$defs/none"})", R"({"$ref": "other.json"})",
                             R"({"$ref": "#/$defs/n", "minimum": 1, "$defs": {"n": {"minimum": 0}}})"}) {
    EXPECT_THROW(Schema(schema, "schema"), std::logic_error) << schema;
  }
}

TEST(EmbeddedSchemas, AreAllWithinWhatIsInterpreted) {
  const std::vector<std::string_view> names = embedded_schema_names();
  EXPECT_NE(std::find(names.begin(), names.end(), "scene"), names.end());
  for (const std::string_view name : names) EXPECT_NO_THROW(embedded_schema(name)) << name;
  EXPECT_THROW(embedded_schema("none"), std::logic_error);
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("radius", "raduis"), 1U) << "a swap of neighbours is one edit";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(nearest_name("velocty", {"position", "velocity", "species"}), "velocity");
  EXPECT_EQ(nearest_name("x", {}), "");
  const std::vector<std::string> keys{"u_A", "u_B", "m_A", "c_retract", "c_revolve", "theta_revolve_deg"};
  EXPECT_EQ(nearest_name("theta", keys), "theta_revolve_deg") << "a part beats few edits";
  EXPECT_EQ(nearest_name("revolve", keys), "c_revolve");
  EXPECT_EQ(nearest_name("theta_revolve_degrees", keys), "theta_revolve_deg");
  EXPECT_EQ(nearest_name("u_C", keys), "u_A") << "one edit beats a part";
  EXPECT_EQ(nearest_name("", keys), "u_A");
  EXPECT_EQ(did_you_mean("theta", keys), "; did you mean theta_revolve_deg?");
  EXPECT_EQ(did_you_mean("c_revolv", keys), "; did you mean c_revolve?");
  for (const char* far : {"foo", "zzz", "mass"}) EXPECT_EQ(did_you_mean(far, keys), ".") << far;
  EXPECT_EQ(did_you_mean("x", {}), ".");
}

TEST(InputError, ListsProblemsInTheOrderOfTheFile) {
  InputProblems problems("f");
  problems.add(7, "/b", "second");
  problems.add(3, "/a", "first");
  problems.add(0, "", "whole file");
  try {
    problems.throw_if_any();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f: whole file\nf:3: /a: first\nf:7: /b: second");
  }
}

TEST(InputError, ShowsAHundredAndCountsTheRest) {
  InputProblems problems("f");
  for (std::size_t k = 1; k <= 1234; ++k) problems.add(k, "", "x");
  try {
    problems.throw_if_any();
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.substr(text.rfind('\n') + 1), "… and at least 900 more");
    EXPECT_NE(text.find("f:100: x"), std::string::npos);
    EXPECT_EQ(text.find("f:101: x"), std::string::npos);
  }
}

}  // namespace
}  // namespace tps
