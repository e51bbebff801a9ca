// A seed names the same cases and scenes whoever compiled the generators: what is recorded here was drawn by
// one compiler and is drawn again by any.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <map>
#include <sstream>

#include "properties/check_law.hpp"
#include "properties/runs/laws.hpp"
#include "reference/text/checksum.hpp"

namespace tps::properties {
namespace {

constexpr std::uint64_t kCases = 100, kScenes = 15;

std::map<std::string, std::string> drawn() {
  std::map<std::string, std::string> checksums;
  for (const Law& law : laws()) {
    std::ostringstream text;
    for (std::uint64_t n = 0; n < kCases; ++n) text << generated_case(law, Format{}, 1, n) << "\n";
    checksums["law:" + law.text.id] = checksum_of(text.str());
  }
  for (const runs::RunLaw& law : runs::run_laws()) {
    std::ostringstream text;
    for (std::uint64_t n = 0; n < kScenes; ++n)
      text << law.scenes(0)(rc::Random(rc::Random::Key{1, n, 0, 0}), 100).value() << "\n";
    checksums["run-law:" + law.name] = checksum_of(text.str());
  }
  return checksums;
}

std::map<std::string, std::string> recorded(const std::string& path) {
  std::map<std::string, std::string> checksums;
  std::ifstream file(path);
  for (std::string name, checksum; file >> name >> checksum;) checksums[name] = checksum;
  return checksums;
}

TEST(SameCases, OfASeedWhoeverCompiledTheGenerators) {
  const std::map<std::string, std::string> present = drawn();
  std::ofstream file("same_cases.present");
  for (const auto& [name, checksum] : present) file << name << " " << checksum << "\n";
  const auto expected = recorded(TPS_SOURCE_DIR "/tests/properties/same_cases.txt");
  for (const auto& [name, checksum] : present)
    EXPECT_EQ(expected.contains(name) ? expected.at(name) : "nothing", checksum)
        << name
        << ": the generator was changed (record same_cases.present of the tests' folder), or draws in an "
        << "order that a compiler chooses: two draws among a call's arguments or an operator's operands";
  EXPECT_EQ(expected.size(), present.size());
}

}  // namespace
}  // namespace tps::properties
