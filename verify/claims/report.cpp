#include "verify/claims/report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "reference/text/plain_json.hpp"

namespace tps::claims {

std::string claims_text(const std::vector<Claim>& claims) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const Claim& claim : claims) {
    fmt::format_to(out, "{}{}: {}\n", text.empty() ? "" : "\n", claim.name, claim.statement);
    fmt::format_to(out, "  paper  {}\n  run    {}\n", claim.source, claim.command);
    for (const Figure& figure : claim.figures) {
      fmt::format_to(out, "  {:<5}  {:<52} {:<18} expected {} [{}]\n", figure.holds ? "ok" : "FAIL",
                     figure.name, figure.measured, figure.expected, figure.derivation);
    }
  }
  return text;
}

std::string claims_json(const std::vector<Claim>& claims) {
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const Claim& claim : claims) {
    nlohmann::ordered_json figures = nlohmann::ordered_json::array();
    for (const Figure& f : claim.figures) {
      figures.push_back({{"name", f.name},
                         {"measured", f.measured},
                         {"expected", f.expected},
                         {"derivation", f.derivation},
                         {"holds", f.holds}});
    }
    result.push_back({{"claim", claim.name},
                      {"statement", claim.statement},
                      {"source", claim.source},
                      {"command", claim.command},
                      {"holds", claim.holds()},
                      {"figures", figures}});
  }
  return json_text(result, 2) + "\n";
}

}  // namespace tps::claims
