// tps claims
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "verify/claims/report.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

std::vector<std::string> claim_names() {
  std::vector<std::string> result;
  for (const claims::ClaimEntry& entry : claims::all_claims()) result.push_back(entry.name);
  return result;
}

std::string claims_footer() {
  std::string text = "Claims:\n";
  for (const claims::ClaimEntry& entry : claims::all_claims()) {
    fmt::format_to(std::back_inserter(text), "  {:<14}{}\n", entry.name, entry.summary);
  }
  return text + "Exit code 1 if a figure is not as expected.\nExample: tps claims collisions stall";
}

/// The claims of these names, of all if there are none, in the order of the paper.
std::vector<claims::Claim> measured(const std::vector<std::string>& wanted) {
  std::vector<claims::Claim> result;
  for (const claims::ClaimEntry& entry : claims::all_claims()) {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), entry.name) != wanted.end()) {
      result.push_back(entry.measure());
    }
  }
  return result;
}

}  // namespace

void add_claims(CLI::App& app, int& exit_code) {
  struct Arguments {
    std::vector<std::string> names;
    std::string format = "text";
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("claims", "Measures what the paper states about its own simulations.");
  verb->add_option("name", a->names, "Which claims (default: all)")->check(CLI::IsMember(claim_names()));
  verb->add_option("--format", a->format)->check(CLI::IsMember({"text", "json"}))->capture_default_str();
  verb->footer(claims_footer());
  verb->callback([a, &exit_code] {
    const std::vector<claims::Claim> results = measured(a->names);
    write_result("-", a->format == "json" ? claims_json(results) : claims_text(results));
    const bool all_hold =
        std::all_of(results.begin(), results.end(), [](const claims::Claim& c) { return c.holds(); });
    exit_code = all_hold ? kDone : kViolation;
  });
}

}  // namespace tps::cli
