#include "reference/text/fields.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace tps {
namespace {

// A field keeps where its document and the file's name are: neither may be gone after the declaration.
static_assert(std::is_constructible_v<Field, const JsonValue&, const std::string&>);
static_assert(!std::is_constructible_v<Field, const JsonValue&, const char*>);
static_assert(!std::is_constructible_v<Field, const JsonValue&, std::string>);
static_assert(!std::is_constructible_v<Field, JsonValue, const std::string&>);

TEST(Fields, NameTheFileOfWhatTheyRefuse) {
  const std::string file = "a file whose name is long enough to be on the heap";
  const JsonDocument document = parse_json("{\"a\":[1,\"x\"]}", file);
  const Field root(document.root, file);
  try {
    root.at("a").list()[1].natural();
    FAIL() << "a word is no number";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().front().file, file);
    EXPECT_EQ(error.problems().front().pointer, "/a/1");
  }
}

}  // namespace
}  // namespace tps
