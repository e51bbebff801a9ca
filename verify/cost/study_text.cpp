#include <fmt/format.h>

#include <map>

#include "verify/cost/levels.hpp"

namespace tps::cost {
namespace {

std::string figure(const Json& value, const char* pointer, const char* form) {
  const Json::json_pointer place(pointer);
  if (!value.contains(place)) return "-";
  return fmt::format(fmt::runtime(form), value.at(place).get<double>());
}

/// "12.3 %, 4.5 %": left the first stage, needed integers.
std::string handed_on(const Json& cell) {
  if (!cell.contains("paths")) return "";
  double counts[3] = {};
  for (std::size_t k = 0; k < 3; ++k) counts[k] = cell.at("paths").at(k).at("questions").get<double>();
  const double all = counts[0] + counts[1] + counts[2];
  return fmt::format("  {:.1f} % left doubles, {:.1f} % came to integers",
                     100 * (counts[1] + counts[2]) / all, 100 * counts[2] / all);
}

/// log2 of the error over the unit roundoff 2^-bits of the variant's arithmetic.
std::string bits_lost(const Json& cell, const char* pointer, int bits) {
  const Json::json_pointer place(pointer);
  if (!cell.contains(place)) return "-";
  const double lost = cell.at(place).get<double>() + bits;
  return lost <= 0 ? "0" : fmt::format("{:.1f}", lost);
}

}  // namespace

std::string report_text(const Json& study) {
  const std::string levels = levels_text(study);
  if (!study.contains("strata")) return levels;
  std::map<std::string, int> bits;
  for (const Json& variant : study.at("variants")) {
    bits[variant.at("name").get<std::string>()] = variant.at("bits").get<int>();
  }
  std::string text;
  for (const Json& stratum : study.at("strata")) {
    if (!text.empty()) text += "\n";
    text +=
        fmt::format("{}: {}\n", stratum.at("name").get<std::string>(), stratum.at("what").get<std::string>());
    text += fmt::format("  {:<22}{:>10}{:>10}{:>8}{:>8}{:>8}{:>7}{:>7}{:>7}  {}\n", "variant", "ns",
                        "x printed", "missed", "invent.", "moved", "lost50", "lost99", "most", "asked");
    for (const Json& cell : stratum.at("cells")) {
      const std::string name = cell.at("variant").get<std::string>();
      const int b = bits.at(name);
      text += fmt::format(
          "  {:<22}{:>10}{:>10}{:>8}{:>8}{:>8}{:>7}{:>7}{:>7}  {}{}\n", name,
          figure(cell, "/ns/throughput/median", "{:.1f}"), figure(cell, "/ratio/value", "{:.2f}"),
          cell.at("missed").get<int>(), cell.at("invented").get<int>(), cell.at("moved").get<int>(),
          bits_lost(cell, "/log2_error/p50", b), bits_lost(cell, "/log2_error/p99", b),
          bits_lost(cell, "/log2_error/max", b), cell.at("asked").get<int>(), handed_on(cell));
    }
  }
  return levels.empty() ? text : text + "\n" + levels;
}

}  // namespace tps::cost
