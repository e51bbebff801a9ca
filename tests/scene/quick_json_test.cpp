// The short road of the reader: what it takes it reads as the long one does, and it takes nothing that is
// wrong.
#include "reference/text/quick_json.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <random>

#include "reference/text/text_file.hpp"

namespace tps {
namespace {

bool operator==(const JsonNumber& a, const JsonNumber& b) {
  return std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value) &&
         a.rounded_integer == b.rounded_integer && a.integer == b.integer && a.magnitude == b.magnitude;
}

bool same(const JsonValue& a, const JsonValue& b) {
  if (a.line != b.line || a.data.index() != b.data.index()) return false;
  if (a.boolean() != nullptr) return *a.boolean() == *b.boolean();
  if (a.number() != nullptr) return *a.number() == *b.number();
  if (a.string() != nullptr) return *a.string() == *b.string();
  if (a.array() != nullptr)
    return std::equal(a.array()->begin(), a.array()->end(), b.array()->begin(), b.array()->end(), same);
  if (a.object() == nullptr) return true;
  return std::equal(a.object()->begin(), a.object()->end(), b.object()->begin(), b.object()->end(),
                    [](const JsonMember& m, const JsonMember& n) {
                      return m.key == n.key && m.key_line == n.key_line && same(m.value, n.value);
                    });
}

/// How many texts were asked and taken.
struct Asked {
  int taken = 0, left = 0;
};

void ask(const std::string& text, const JsonLimits& limits, Asked& asked) {
  constexpr std::size_t kFirstLine = 7;
  const std::optional<JsonValue> quick = quick_json(text, limits, kFirstLine);
  ++(quick ? asked.taken : asked.left);
  if (!quick) return;
  try {
    const JsonDocument slow = parse_any_json(text, "text", limits, kFirstLine);
    slow.problems.throw_if_any();
    EXPECT_TRUE(same(*quick, slow.root)) << text;
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what() << '\n' << text;
  }
}

constexpr std::string_view kLetters = "{}[],:\"\\ \n\r\t0123456789.eE+-truefalsn\x7f\x80";

std::string damaged(std::string text, std::mt19937_64& random) {
  const auto place = [&] { return random() % text.size(); };
  for (std::uint64_t n = 1 + random() % 3; n > 0 && !text.empty(); --n) {
    const char letter = kLetters[random() % kLetters.size()];
    switch (random() % 4) {
      case 0:
        text.erase(place(), 1 + random() % 3);
        break;
      case 1:
        text.insert(place(), 1, letter);
        break;
      case 2:
        text[place()] = letter;
        break;
      default:
        text.insert(place(), text.substr(place(), 12));
    }
  }
  return text;
}

TEST(QuickJson, ReadsScenesAndTheirDamagedCopiesAsTheLongRoadDoes) {
  std::mt19937_64 random(1);
  const JsonLimits narrow{.max_bytes = 4000, .max_depth = 5, .max_key = 12, .max_values = 200};
  Asked asked;
  for (const char* folder : {"/tests/scene/good", "/tests/scene/broken", "/data/scenes"}) {
    for (const auto& file : std::filesystem::directory_iterator(TPS_SOURCE_DIR + std::string(folder))) {
      if (file.path().extension() != ".json" || file.file_size() > 10'000) continue;
      const std::string text = read_text_file(file.path().string(), JsonLimits{}.max_bytes, "");
      ask(text, {}, asked);
      for (int n = 0; n < 100; ++n) ask(damaged(text, random), n % 2 == 0 ? JsonLimits{} : narrow, asked);
    }
  }
  EXPECT_GT(asked.taken, 1000);
  EXPECT_GT(asked.left, 1000);
}

TEST(QuickJson, ReadsNumbersAsTheLongRoadDoes) {
  std::mt19937_64 random(2);
  Asked asked;
  for (int n = 0; n < 30'000; ++n) {
    std::string letters, digits;
    for (std::uint64_t k = 1 + random() % 12; k > 0; --k) letters += "0123456789.eE+- \n-01"[random() % 20];
    for (std::uint64_t k = 1 + random() % 22; k > 0; --k) digits += static_cast<char>('0' + random() % 10);
    const std::string exponent = std::to_string(random() % 700);
    for (const std::string& text : {letters, "[" + letters + "]", digits, "-" + digits,
                                    digits + "e-" + exponent, "[0." + digits + "E+" + exponent + "\n]"})
      ask(text, {}, asked);
  }
  EXPECT_GT(asked.taken, 50'000);
  EXPECT_GT(asked.left, 20'000);
}

TEST(QuickJson, LeavesWhatTakesCare) {
  for (const char* text : {"", " ", "{\"a\":1,\"a\":2}", "\"\\u0041\"", "\"\xc3\xa9\"", "[1]x", "[1,]", "01",
                           "-", "1.", "[1e999]", "nul", "\xef\xbb\xbf{}"})
    EXPECT_FALSE(quick_json(text, {}, 1).has_value()) << text;
  EXPECT_TRUE(quick_json("{\"a\": [1, -0.5e3, \"b\", true, false, null, {}]}\n", {}, 1).has_value());
}

}  // namespace
}  // namespace tps
