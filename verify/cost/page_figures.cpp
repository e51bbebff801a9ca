#include "verify/cost/page_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verify/cost/json_at.hpp"
#include "verify/cost/plot.hpp"
#include "verify/cost/variant.hpp"

namespace tps::cost {
namespace {

/// Colours of the style sheet that differ most, from the least digits to the most.
constexpr int kArithmeticColours[] = {0, 1, 3, 4, 7, 8, 10};

const Json& variant_named(const Json& study, const std::string& name) {
  const Json& all = study.at("variants");
  return *std::find_if(all.begin(), all.end(), [&](const Json& v) { return v.at("name") == name; });
}

std::uint64_t wrong_in(const Json& verdicts) {
  return verdicts.at("missed").get<std::uint64_t>() + verdicts.at("invented").get<std::uint64_t>() +
         verdicts.at("moved").get<std::uint64_t>();
}

/// What a figure has room for beside a point.
std::string short_name(const Json& study, const std::string& variant) {
  static const std::map<std::string, std::string> letters = {
      {"float", "24"}, {"double", "53"},  {"long-double", "64"}, {"double-word", "106"}, {"quad", "113"},
      {"mp50", "50d"}, {"mp100", "100d"}, {"mpfr50", "50m"},     {"mpfr100", "100m"},    {"", "c"}};
  const std::string arithmetic = text_at(variant_named(study, variant), "arithmetic");
  const auto found = letters.find(arithmetic);
  return found == letters.end() ? arithmetic : found->second;
}

struct Candidate {
  Position at;
  std::string variant, tip;
  bool wrong;
};

/// From the fastest on, each that is more accurate than all before it.
std::vector<Position> front(std::vector<Candidate> all, bool with_wrong) {
  std::sort(all.begin(), all.end(), [](const Candidate& p, const Candidate& q) {
    return p.at.x != q.at.x ? p.at.x < q.at.x : p.at.y < q.at.y;
  });
  std::vector<Position> result;
  for (const Candidate& candidate : all) {
    if (candidate.wrong && !with_wrong) continue;
    if (!result.empty() && candidate.at.y >= result.back().y) continue;
    if (!result.empty()) result.push_back({candidate.at.x, result.back().y});
    result.push_back(candidate.at);
  }
  return result;
}

bool on(const std::vector<Position>& front, Position at) {
  return std::any_of(front.begin(), front.end(), [&](Position p) { return p.x == at.x && p.y == at.y; });
}

std::vector<Candidate> candidates(const Json& stratum) {
  std::vector<Candidate> result;
  for (const Json& cell : stratum.at("cells")) {
    if (!cell.contains("ns") || !cell.at("log2_error").contains("p99")) continue;
    const double ns = cell.at("ns").at("throughput").at("median").get<double>();
    const double error = cell.at("log2_error").at("p99").get<double>();
    const std::uint64_t wrong = wrong_in(cell);
    result.push_back(
        {{std::log10(ns), error},
         text_at(cell, "variant"),
         fmt::format("{}: {:.4g} ns, error 2^{:.1f} at p99, 2^{:.1f} at most, {} of {} verdicts wrong",
                     text_at(cell, "variant"), ns, error, cell.at("log2_error").at("max").get<double>(),
                     wrong, cell.at("asked").get<std::uint64_t>()),
         wrong > 0});
  }
  return result;
}

/// The variants of a selection by name, with the style of their lines.
std::map<std::string, std::string> selected(const Json& study, const Selection& selection) {
  std::map<std::string, std::string> styles;
  for (const Json& variant : study.at("variants")) {
    const std::string name = text_at(variant, "name");
    if (text_at(variant, "arithmetic") == kForeignArithmetic) {
      styles[name] = series(study, name);
    } else if (selection.formula.empty()) {
      if (text_at(variant, "arithmetic") == selection.arithmetic) styles[name] = series(study, name);
    } else if (text_at(variant, "formula") == selection.formula) {
      styles[name] =
          fmt::format("series-{}", kArithmeticColours[styles.size() % std::size(kArithmeticColours)]);
    }
  }
  return styles;
}

/// The name of a line at its first point.
std::string line_name(const Json& study, const std::string& variant, const Selection& selection) {
  const Json& v = variant_named(study, variant);
  return text_at(v, selection.formula.empty() ? "formula" : "arithmetic");
}

bool aims_at_range(const std::string& stratum) {
  return stratum == "any_scale" || stratum == "wide" || stratum == "subnormal" || stratum == "units";
}

}  // namespace

std::string series(const Json& study, const std::string& variant) {
  const std::string formula = text_at(variant_named(study, variant), "formula");
  const Json& all = study.at("formulas");
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Json& f) { return f.at("name") == formula; });
  return fmt::format("series-{}", found - all.begin());
}

std::string pareto_figure(const Json& study, const Json& stratum) {
  const std::vector<Candidate> all = candidates(stratum);
  Plot plot(text_at(stratum, "name") + ": " + text_at(stratum, "what"), {"ns a question", 0, 6, 10, 1},
            {"relative error of the time, p99", -180, 10, 2, 20});
  const std::vector<Position> best = front(all, true);
  const std::vector<Position> best_right = front(all, false);
  plot.line(best, "front");
  plot.line(best_right, "front right");
  for (const Candidate& c : all) {
    const bool leads = on(best, c.at) || on(best_right, c.at);
    plot.point(c.at, series(study, c.variant), leads ? short_name(study, c.variant) : "", c.tip, c.wrong);
  }
  return plot.figure();
}

std::string tangency_figure(const Json& study, const Json& stratum, const Selection& selection) {
  Plot plot(selection.title, {"distance from tangency, |1 - (rho/L)^2|", -60, 2, 2, 10},
            {"wrong verdicts, %", 0, 100, 0, 20});
  const std::map<std::string, std::string> styles = selected(study, selection);
  std::map<std::string, std::vector<Position>> lines;
  for (const Json& bin : stratum.at("by_tangency")) {
    const std::string variant = text_at(bin, "variant");
    if (!styles.contains(variant)) continue;
    const auto asked = bin.at("asked").get<std::uint64_t>();
    const std::uint64_t wrong = wrong_in(bin);
    const int exponent = bin.at("log2_distance").get<int>();
    const Position at{exponent + 0.5, 100 * static_cast<double>(wrong) / static_cast<double>(asked)};
    lines[variant].push_back(at);
    plot.point(at, styles.at(variant), "",
               fmt::format("{}: {} of {} wrong between 2^{} and 2^{}", variant, wrong, asked, exponent,
                           exponent + 1));
  }
  for (const auto& [variant, points] : lines) plot.line(points, styles.at(variant));
  return plot.figure();
}

std::string condition_figure(const Json& study, const Selection& selection) {
  constexpr int kMost = 60;
  Plot plot(selection.title, {"condition number", 0, kMost, 2, 10},
            {"largest relative error", -180, 10, 2, 20});
  const std::map<std::string, std::string> styles = selected(study, selection);
  std::map<std::string, std::map<int, double>> largest;
  for (const Json& stratum : study.at("strata")) {
    if (aims_at_range(text_at(stratum, "name"))) continue;
    for (const Json& bin : stratum.at("by_condition")) {
      const std::string variant = text_at(bin, "variant");
      const int exponent = bin.at("log2_condition").get<int>();
      if (!styles.contains(variant) || exponent < 0 || exponent >= kMost) continue;
      const double error = bin.at("log2_error_max").get<double>();
      const auto [place, is_new] = largest[variant].emplace(exponent, error);
      if (!is_new) place->second = std::max(place->second, error);
    }
  }
  for (const auto& [variant, errors] : largest) {
    const std::string& style = styles.at(variant);
    std::vector<Position> points;
    for (const auto& [exponent, error] : errors) {
      const bool first = points.empty();
      points.push_back({exponent + 0.5, error});
      plot.point(points.back(), style, first ? line_name(study, variant, selection) : "",
                 fmt::format("{}: at most 2^{:.1f} at a condition between 2^{} and 2^{}", variant, error,
                             exponent, exponent + 1));
    }
    plot.line(points, style);
    const double bits = variant_named(study, variant).at("bits").get<double>();
    plot.line({{0, -bits}, {kMost, kMost - bits}}, "envelope");
  }
  return plot.figure();
}

}  // namespace tps::cost
