#include "tests/fuzz/damage.hpp"

#include <algorithm>

namespace tps::fuzz {
namespace {

std::size_t below(std::size_t most, std::mt19937_64& random) {
  return most == 0 ? 0 : static_cast<std::size_t>(random() % most);
}

/// A value of JSON around a place: from behind the last of ":,[{" to before the next of ",]}".
void replace_value(std::string& text, std::size_t at, const std::string& word) {
  const std::size_t before = text.find_last_of(":,[{", at);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::size_t end = std::min(text.find_first_of(",]}", begin), text.size());
  text.replace(begin, end - begin, word);
}

void damage_once(std::string& text, const std::vector<std::string>& dictionary, std::mt19937_64& random) {
  const std::size_t at = below(text.size() + 1, random);
  const std::size_t length = std::min<std::size_t>(1 + below(40, random), text.size() - at);
  const std::string word = dictionary.empty() ? "0" : dictionary[below(dictionary.size(), random)];
  switch (random() % 9) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(random());
      break;
    case 1:
      if (at < text.size()) text[at] = "0123456789abcdef\"[]{},:-+.pxn"[below(29, random)];
      break;
    case 2:
      text.erase(at, length);
      break;
    case 3:
      text.insert(at, text.substr(at, length));
      break;
    case 4:
      text.insert(below(text.size() + 1, random), text.substr(at, length));
      break;
    case 5:
      text.resize(at);
      break;
    case 6:
      text.insert(at, word);
      break;
    default:
      replace_value(text, at, word);
  }
}

}  // namespace

std::string damaged(std::string text, const std::vector<std::string>& dictionary, std::mt19937_64& random) {
  for (std::uint64_t times = 1 + random() % 4; times > 0; --times) damage_once(text, dictionary, random);
  return text;
}

}  // namespace tps::fuzz
