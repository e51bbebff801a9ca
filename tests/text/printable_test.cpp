// What others wrote, made safe for terminals and XML.
#include "reference/text/printable.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"

namespace tps {
namespace {

TEST(Printable, LeavesWordsOfEveryLanguageAlone) {
  for (const char* text :
       {"", "plain", "Grüße, κόσμε, 世界, 🙂", "back\\slash \"quote\" <tag> & so on"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\x1b[31mred\\x07");
  EXPECT_EQ(printable("one\ntwo\r\tthree\x7f"), "one\\ntwo\\r\\tthree\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u009b31m")
      << "CSI of eight bits";
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "drow"),
            "\\u202edrow")
      << "the right-to-left override";
  EXPECT_EQ(printable("\xe2\x80\xa8"), "\\u2028") << "the line separator";
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Printable, EscapesWhatIsNotUtf8) {
  EXPECT_EQ(printable("\xff\xc0\x80"), "\\xff\\xc0\\x80") << "an overlong NUL is no character";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "nor is a surrogate";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "nor what is beyond U+10FFFF";
  EXPECT_EQ(printable("\xe4\xb8"), "\\xe4\\xb8") << "nor a beginning";
  EXPECT_EQ(printable("\xef\xbf\xbf"), "\\uffff");
}

TEST(Printable, IsBoundedAtACharacter) {
  EXPECT_EQ(printable("abcdef", 3), "abc…");
  EXPECT_EQ(printable("ääää", 5), "ää…");
  EXPECT_EQ(printable("abc", 3), "abc");
}

std::string random_bytes(std::mt19937& random) {
  static const char* const pieces[] = {"\x1b",
                                       "\n",
                                       "\xff",
                                       "\xc2\x9b",
                                       "\xe2\x80\xae",
                                       "\xef\xbf\xbe",
                                       "\xed\xb0\x80",
                                       "&",
                                       "<",
                                       "]]>",
                                       "\"",
                                       "'",
                                       "ordinary",
                                       "ä",
                                       "\xf0\x9f\x99\x82",
                                       "\xf3\xa0\x81\x81"};
  std::string text;
  for (std::size_t n = random() % 12; n > 0; --n) {
    if (random() % 3 == 0)
      text += static_cast<char>(random());
    else
      text += pieces[random() % std::size(pieces)];
  }
  return text;
}

TEST(Printable, OfRandomBytesIsOneLineWithoutControls) {
  std::mt19937 random(3);
  for (int n = 0; n < 3000; ++n) {
    const std::string text = printable(random_bytes(random));
    for (const char c : text) EXPECT_FALSE((c >= 0 && c < ' ') || c == 0x7f) << text;
    EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
    EXPECT_EQ(printable(text), text) << "(1)";
    EXPECT_EQ(nlohmann::json(text).dump().empty(), false) << "throws where it is not UTF-8";
  }
}

/// Whether XML 1.0 allows each character, and no markup is left.
bool is_xml_text(std::string text) {
  const std::string as_json = nlohmann::json(text).dump();  // throws where it is not UTF-8
  for (const char c : text) {
    if ((c >= 0 && c < ' ' && c != '\n' && c != '\t') || c == 0x7f || c == '<' || c == '>' || c == '"')
      return false;
  }
  return text.find("\xef\xbf\xbe") == std::string::npos && text.find("\xef\xbf\xbf") == std::string::npos;
}

TEST(XmlText, IsXmlWhateverTheBytes) {
  std::mt19937 random(4);
  for (int n = 0; n < 3000; ++n) EXPECT_TRUE(is_xml_text(xml_text(random_bytes(random))));
  EXPECT_EQ(xml_text("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; 'd'");
  EXPECT_EQ(xml_text("\x1b\xef\xbf\xbf\xff"), "���");
}

TEST(JsonText, ReadsBackAndShowsNoControls) {
  std::mt19937 random(5);
  for (int n = 0; n < 1000; ++n) {
    const nlohmann::ordered_json value = {
        {"text", printable(random_bytes(random)) + "\xc2\x9b\xe2\x80\xae\x1b"}};
    const std::string text = json_text(value);
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(parse_plain_json(text, "again"), value);
  }
}

TEST(InputError, IsSafeWhateverTheFileIsCalled) {
  const InputError error({{"bad\x1b[31m\nname", 3, "/\x1b", "found \xff"}});
  EXPECT_STREQ(error.what(), "bad\\x1b[31m\\nname:3: /\\x1b: found \\xff");
  const InputError longest({{"f", 1, std::string(1'000'000, 'p'), std::string(1'000'000, 'm')}});
  EXPECT_LT(std::string(longest.what()).size(), 3000U);
}

}  // namespace
}  // namespace tps
