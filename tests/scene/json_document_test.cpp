// The tree, its lines, and texts that are hostile to whoever reads them.
#include "reference/text/json_document.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

#include "reference/scene/read_scene.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/text_file.hpp"
#include "tests/support/processor_time.hpp"

namespace tps {
namespace {

constexpr std::size_t mega = std::size_t{1} << 20;

std::string refusal(const std::string& text) {
  try {
    read_scene_text(text, "hostile");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string concat(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string repeated(const std::string& part, std::size_t bytes) {
  std::string text;
  text.reserve(bytes + part.size());
  while (text.size() < bytes) text += part;
  return text;
}

// A file of this process that disappears with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / (name + std::to_string(getpid()))) {}
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::string file_refusal(const std::string& path) {
  try {
    read_scene_file(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(JsonDocument, EveryValueKnowsItsLine) {
  const JsonDocument document = parse_json("{\"a\": [1,\n2\n,\"x\"],\n\n\"b\":\n{\"c\": null}\n}", "lines");
  const auto line = [&](const char* pointer) { return resolve_pointer(document.root, pointer).line; };
  EXPECT_EQ(line(""), 1U);
  EXPECT_EQ(line("/a"), 1U);
  EXPECT_EQ(line("/a/0"), 1U);
  EXPECT_EQ(line("/a/1"), 2U) << "a number is known to end only after the line end";
  EXPECT_EQ(line("/a/2"), 3U);
  EXPECT_EQ(line("/b"), 6U) << "of the value; its key is on line 5";
  EXPECT_EQ((*document.root.object())[1].key_line, 5U);
  EXPECT_EQ(line("/b/c"), 6U);
}

TEST(JsonDocument, LinesCountFromTheGivenOne) {
  EXPECT_EQ(parse_json("[1]", "stream", {}, 41).root.line, 41U);
}

TEST(JsonDocument, NumbersAreTheNearestDoubles) {
  const JsonDocument document = parse_json(
      "[0.1, -0, 9007199254740993, 18446744073709551616, 18446744073709551615, 1e-400, 2.5e0, "
      "9007199254740992]",
      "numbers");
  const auto number = [&](std::size_t k) { return *(*document.root.array())[k].number(); };
  EXPECT_EQ(number(0).value, 0.1);
  EXPECT_TRUE(std::signbit(number(1).value));
  EXPECT_EQ(number(2).value, 9007199254740992.0);
  EXPECT_TRUE(number(2).rounded_integer);
  EXPECT_EQ(number(3).value, 0x1p64);
  EXPECT_EQ(number(4).value, 0x1p64);
  EXPECT_TRUE(number(4).rounded_integer);
  EXPECT_EQ(number(5).value, 0.0);
  EXPECT_FALSE(number(6).rounded_integer);
  EXPECT_FALSE(number(7).rounded_integer);
}

TEST(JsonDocument, PointersEscapeTheirKeys) {
  const JsonDocument document = parse_json("{\"a/b\": {\"m~n\": [7]}}", "keys");
  const JsonPath top;
  const JsonPath outer = top.key("a/b");
  const JsonPath inner = outer.key("m~n");
  EXPECT_EQ(inner.item(0).text(), "/a~1b/m~0n/0");
  EXPECT_EQ(resolve_pointer(document.root, "/a~1b/m~0n/0").number()->value, 7);
}

TEST(HostileText, FullOfZerosIsRefused) {
  const double start = processor_seconds();
  EXPECT_EQ(refusal(std::string(300 * mega, '\0')), "hostile:1: 314572800 bytes; at most 268435456 are read");
  EXPECT_EQ(refusal(std::string(60 * mega, '\0')), "hostile:1: the byte at offset 0 is NUL; this is no text");
  EXPECT_EQ(refusal(std::string(60 * mega, '0')),
            "hostile:1: not JSON: unexpected number literal; expected end of input (column 3)");
  EXPECT_EQ(refusal(concat({"[", repeated("0,", 60 * mega)})),
            "hostile:1: /15999999: more than 16000000 values, the most that is read");
  EXPECT_EQ(refusal(concat({"[", repeated("[],", 60 * mega)})),
            "hostile:1: /15999999: more than 16000000 values, the most that is read");
  EXPECT_LT(processor_seconds() - start, 60) << "a hang, not a measurement";
}

TEST(HostileText, TextAfterNulIsNotTakenForTheEnd) {
  EXPECT_EQ(refusal(std::string("{}\0{}", 5)), "hostile:1: the byte at offset 2 is NUL; this is no text");
}

TEST(HostileText, LongTokensAreCutInMessages) {
  EXPECT_LT(refusal(concat({"[", std::string(mega, '9'), "]"})).size(), 200U);
  EXPECT_LT(refusal(concat({"\"", std::string(mega, 'x')})).size(), 200U);
  EXPECT_LT(refusal(concat({"\"", std::string(mega, 'x'), "\""})).size(), 300U);
  EXPECT_LT(
      refusal(concat({"{\"", std::string(mega, 'x'), "\": 1, \"", std::string(mega, 'x'), "\": 2}"})).size(),
      2000U);
}

TEST(HostileText, DeepNestingIsRefusedWithoutRecursion) {
  const std::string message = refusal(std::string(mega, '['));
  EXPECT_NE(message.find("lists and objects inside each other more than 64 deep"), std::string::npos)
      << message;
  EXPECT_NE(refusal(repeated("{\"a\":", mega)).find("more than 64 deep"), std::string::npos);
}

TEST(HostileText, AMillionErrorsAreCappedInTheMessage) {
  const std::string entries = repeated("{\"x\":0},", 8 * mega);
  const std::string message =
      refusal(concat({"{\"particles\":[", entries.substr(0, entries.size() - 1), "]}"}));
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 100);
  EXPECT_NE(message.find("\n… and at least 900 more"), std::string::npos);
}

TEST(HostileText, AMillionKeysAreRefusedQuickly) {
  std::string text = "{";
  for (int k = 0; k < 300000; ++k) text += concat({"\"k", std::to_string(k), "\":0,"});
  text += "\"k0\":0}";
  const std::string message = refusal(text);
  EXPECT_NE(message.find("key \"k0\" stands twice"), std::string::npos) << message.substr(0, 500);
}

TEST(HostileFile, DevicesAreReadUpToTheLimitOnly) {
  EXPECT_EQ(
      file_refusal("/dev/zero"),
      "/dev/zero: is larger than 268435456 bytes, the most that is read; a scene of this size has too many "
      "particles for one run: use fewer");
}

TEST(HostileFile, WhatIsNoFileIsNamed) {
  EXPECT_EQ(file_refusal("/dev/null"), "/dev/null:1: is empty; a JSON document is needed");
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(file_refusal(folder), concat({folder, ": this is a directory; name a file in it"}));
  EXPECT_EQ(file_refusal("no/such/scene.json"),
            "no/such/scene.json: cannot be opened: No such file or directory");
}

TEST(HostileFile, UnreadableIsSaid) {
  // Opens for everybody, root included, and has nothing to read at its start.
  EXPECT_EQ(file_refusal("/proc/self/mem"), "/proc/self/mem: cannot be read: Input/output error");
}

}  // namespace
}  // namespace tps
