#include "properties/conform/asked_otherwise.hpp"

#include <map>
#include <memory>

#include "properties/implementations/reference.hpp"

namespace tps::properties::conform {

Vec numbers_as(const Expected& right, const Json& out) {
  Vec all;
  for (const ExpectedNumbers& numbers : right.numbers) {
    const auto found = numbers_of(out.value(numbers.key, Json()));
    if (!found || found->size() != numbers.ends.size()) return {};
    all.insert(all.end(), found->begin(), found->end());
  }
  return all;
}

Vec nearest_numbers(const Expected& right) {
  Vec all;
  for (const ExpectedNumbers& numbers : right.numbers) {
    for (const ExpectedNumbers::End& end : numbers.ends) all.push_back(end.nearest);
  }
  return all;
}

Vec reference_answer(const std::string& scalar, Op op, const Json& in, const Expected& right) {
  static std::map<std::string, std::unique_ptr<Implementation>> references;
  auto& asked = references[scalar];
  if (asked == nullptr) asked = reference(scalar);
  const Answer answer = asked->ask({op, in});
  return answer.status == Answer::Status::answered ? numbers_as(right, answer.out) : Vec{};
}

}  // namespace tps::properties::conform
