// Laws that were not asked, in few words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "properties/conform/report.hpp"

namespace tps::properties::conform {
namespace {

/// Laws of one subject that need the same.
struct Together {
  std::string of, needs;
  std::vector<int> numbers;
};

/// "(2) law 1" is law 1 of (2).
Together alone(const LawNotAsked& law) {
  const std::size_t end = law.number.find(" law ");
  return {law.number.substr(0, end),
          fmt::format("{}", fmt::join(law.needs, ", ")),
          {std::atoi(law.number.c_str() + end + 5)}};
}

/// "1, 2, 4–9".
std::string ranges(const std::vector<int>& numbers) {
  std::vector<std::string> parts;
  for (std::size_t first = 0; first < numbers.size();) {
    std::size_t last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (last == first + 1) last = first;  // two are listed
    parts.push_back(last > first ? fmt::format("{}–{}", numbers[first], numbers[last])
                                 : fmt::format("{}", numbers[first]));
    first = last + 1;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::string laws_not_asked_in_words(const Verdict& verdict) {
  std::vector<Together> all;
  for (const LawNotAsked& law : verdict.laws_not_asked) {
    Together one = alone(law);
    const auto same = std::find_if(all.begin(), all.end(), [&](const Together& other) {
      return other.of == one.of && other.needs == one.needs;
    });
    if (same == all.end()) {
      all.push_back(std::move(one));
    } else {
      same->numbers.push_back(one.numbers.front());
    }
  }
  std::vector<std::string> parts;
  for (const Together& each : all) {
    const bool one = each.numbers.size() == 1;
    parts.push_back(fmt::format("{} {} of {}{} {} {}", one ? "law" : "laws", ranges(each.numbers),
                                each.of.starts_with('(') ? "eq. " : "", each.of, one ? "needs" : "need",
                                each.needs));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace tps::properties::conform
