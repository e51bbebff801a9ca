// Each law of the registry as a test of the same name: the reference at every scalar, and its certified
// answers.
#include <gtest/gtest.h>

#include <sstream>

#include "properties/check_law.hpp"
#include "properties/implementations/reference.hpp"

namespace tps::properties {
namespace {

/// Wide scalars are slow, and what they add is a smaller u.
struct Subject {
  const char* name;
  std::uint64_t cases;
};
constexpr Subject kSubjects[] = {{"double", 400}, {"float", 200}, {"long-double", 100}, {"quad", 40},
                                 {"mp50", 40},    {"mp100", 40},  {"certified", 100}};

class LawTest : public testing::Test {
 public:
  explicit LawTest(const Law& law) : law_(law) {}

  void TestBody() override {
    std::uint64_t held = 0, asked = 0;
    for (const Subject& subject : kSubjects) {
      const auto implementation = reference(subject.name);
      Tally tally;
      const auto finding =
          check_law(law_, *implementation,
                    {.seed = 20260101, .first = 0, .count = subject.cases, .bitwise = true}, tally);
      if (finding) {
        std::ostringstream text;
        text << finding->shrunk << "\ngenerated: " << finding->generated;
        ADD_FAILURE() << law_.text.sentence << "\n"
                      << implementation->name() << ", case " << finding->number << ": "
                      << finding->outcome.why << "\n"
                      << text.str();
      }
      held += tally.held;
      asked += tally.held + tally.outside;
    }
    EXPECT_GE(10 * held, asked) << "of " << asked << " cases the law says something about " << held
                                << " only";
    EXPECT_GE(held, 40U) << "cases in which the law says something";
  }

 private:
  const Law& law_;
};

const bool registered = [] {
  for (const Law& law : laws()) {
    const std::size_t dot = law.text.id.find('.');
    testing::RegisterTest(law.text.id.substr(0, dot).c_str(), law.text.id.substr(dot + 1).c_str(), nullptr,
                          nullptr, __FILE__, __LINE__,
                          [&law]() -> testing::Test* { return new LawTest(law); });
  }
  return true;
}();

}  // namespace
}  // namespace tps::properties
