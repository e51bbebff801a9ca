// Pictures of states: well-formed, complete, and sane for degenerate states.
#include "verify/draw/draw_svg.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <regex>
#include <set>
#include <stdexcept>

#include "reference/scene/clusters.hpp"
#include "verify/draw/view.hpp"
#include "verify/scenes/registry.hpp"

namespace tps {
namespace {

using Positions = std::vector<std::array<double, 3>>;

Positions starts(const Scene& scene) {
  Positions positions;
  for (const Particle& particle : scene.particles) positions.push_back(particle.position);
  return positions;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// What a reader of XML would object to: "" for a well-formed document of elements, attributes and text.
std::string xml_objection(const std::string& text) {
  static const std::regex tag(R"re(<(/?)([A-Za-z]+)((?: [A-Za-z0-9-]+="[^"<]*")*)(/?)>)re");
  static const std::regex reference("&(?!(?:amp|lt|gt|quot);)");
  if (std::regex_search(text, reference)) return "a bare &";
  std::vector<std::string> open;
  std::size_t at = 0;
  bool had_root = false;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    const auto start = static_cast<std::size_t>(it->position());
    const std::string between = text.substr(at, start - at);
    if (between.find_first_of("<>") != std::string::npos) return "a bare < or > in: " + between;
    if (open.empty() && between.find_first_not_of("\n") != std::string::npos)
      return "text outside: " + between;
    at = start + static_cast<std::size_t>(it->length());
    if ((*it)[1].length() > 0) {
      if (open.empty() || open.back() != (*it)[2]) return "closes " + (*it)[2].str();
      open.pop_back();
    } else {
      if (open.empty() && had_root) return "a second root";
      had_root = true;
      if ((*it)[4].length() == 0) open.push_back((*it)[2]);
    }
  }
  if (text.substr(at) != "\n") return "a remainder: " + text.substr(at);
  return open.empty() && had_root ? "" : "not closed";
}

/// A scene of `n` particles of radius 1 without laws.
Scene plain(int n) {
  Scene scene;
  scene.species = {{.name = "a", .mass = 1, .radius = 1, .max_tethers = {}}};
  for (int i = 0; i < n; ++i)
    scene.particles.push_back({.id = i, .species = 0, .position = {}, .velocity = {}});
  return scene;
}

TEST(DrawSvg, ObjectionsAreFound) {
  EXPECT_EQ(xml_objection("<a b=\"c\"><d/>&amp;</a>\n"), "");
  EXPECT_NE(xml_objection("<a>&</a>\n"), "");
  EXPECT_NE(xml_objection("<a><b></a>\n"), "");
  EXPECT_NE(xml_objection("<a b=c></a>\n"), "");
  EXPECT_NE(xml_objection("<a> < </a>\n"), "");
}

TEST(DrawSvg, EveryCatalogueSceneIsWellFormedAndComplete) {
  for (const SceneBuilder& builder : scene_builders()) {
    const Scene scene = builder.build({});
    const std::string svg = draw_svg(scene, starts(scene), scene.tethers, {.time = 0.5});
    EXPECT_EQ(xml_objection(svg), "") << builder.name;
    const std::set<std::string> contained{
        "terminal", "terminal-action-potential", "gas", "brownian", "sediment", "granular", "rough"};
    const std::size_t containers = contained.count(builder.name);
    EXPECT_EQ(count(svg, "class=\"container\""), containers) << builder.name;
    EXPECT_EQ(count(svg, "class=\"particle\""), scene.particles.size() - containers) << builder.name;
    EXPECT_EQ(count(svg, "class=\"tether\""), scene.tethers.size()) << builder.name;
    EXPECT_EQ(count(svg, "class=\"key\""), scene.species.size()) << builder.name;
    EXPECT_EQ(count(svg, "t = 0.5"), 1U);
    EXPECT_EQ(count(svg, "nan"), 0U) << builder.name;
    EXPECT_EQ(count(svg, "inf"), 0U) << builder.name;
  }
}

TEST(DrawSvg, NamesAndTitlesAreEscaped) {
  Scene scene = plain(1);
  scene.title = "a < b && \"c\" > d\x01";
  scene.species[0].name = "<&>";
  const std::string svg = draw_svg(scene, starts(scene), {});
  EXPECT_EQ(xml_objection(svg), "");
  EXPECT_NE(svg.find("a &lt; b &amp;&amp; &quot;c&quot; &gt; d\\x01"), std::string::npos);
  EXPECT_NE(svg.find("1 × &lt;&amp;&gt;"), std::string::npos);
}

TEST(DrawSvg, DegenerateStatesStayInsideThePicture) {
  constexpr double kHuge = std::numeric_limits<double>::max();
  const std::vector<Positions> states{
      {},
      {{0, 0, 0}},
      {{5, 5, 5}, {5, 5, 5}},
      {{-kHuge, -kHuge, -kHuge}, {kHuge, kHuge, kHuge}},
      {{0, 0, 0}, {5e-324, 0, 0}},
      {{1e300, 0, 0}, {-1e300, 1, 1}, {0, 0, 0}},
  };
  for (const Positions& state : states) {
    for (const double radius : {0.0, 1.0, 1e300}) {
      Scene scene = plain(static_cast<int>(state.size()));
      scene.species[0].radius = radius;
      EXPECT_EQ(xml_objection(draw_svg(scene, state, {})), "");
      for (const Seen& seen : fit_to_picture(scene, state, 720)) {
        EXPECT_TRUE(seen.x - seen.radius >= 0 && seen.x + seen.radius <= 720) << seen.x << " " << seen.radius;
        EXPECT_TRUE(seen.y - seen.radius >= 0 && seen.y + seen.radius <= 720) << seen.y << " " << seen.radius;
        EXPECT_TRUE(seen.depth >= 0 && seen.depth <= 1) << seen.depth;
      }
    }
  }
}

TEST(DrawSvg, YPointsUpAndTheNearestIsPaintedLast) {
  Scene scene = plain(2);
  const Positions state{{0, 2, 1}, {0, -2, -1}};
  const auto seen = fit_to_picture(scene, state, 720);
  EXPECT_LT(seen[0].y, seen[1].y);
  EXPECT_EQ(seen[0].depth, 1);
  EXPECT_EQ(seen[1].depth, 0);
  const std::string svg = draw_svg(scene, state, {});
  EXPECT_GT(svg.find("fill=\"url(#s0d3)\" stroke", svg.find("class=\"particle\"")),
            svg.find("fill=\"url(#s0d0)\""));
}

TEST(DrawSvg, ClustersAreThoseOfTheObservation) {
  Scene scene = plain(7);
  scene.species.push_back({.name = "b", .mass = 1, .radius = 1, .max_tethers = {}});
  scene.particles[1].species = 1;
  scene.particles[5].species = 1;
  // 0-1-2-3 holds three of "a"; 4-5-6 two.
  const std::vector<Tether> tethers{{2, 3}, {0, 1}, {1, 2}, {4, 5}, {5, 6}};
  using Clusters = std::vector<std::vector<int>>;
  EXPECT_EQ(clusters_of(scene, tethers, {.species = 0, .at_least = 3}), (Clusters{{0, 1, 2, 3}}));
  EXPECT_EQ(clusters_of(scene, tethers, {.species = 0, .at_least = 2}), (Clusters{{0, 1, 2, 3}, {4, 5, 6}}));
  scene.clusters = ClusterObservation{.species = 0, .at_least = 2};
  EXPECT_NE(draw_svg(scene, starts(scene), tethers).find("2 clusters of at least 2 × a"), std::string::npos);
}

TEST(DrawSvg, WhatCannotBeDrawnIsNamed) {
  const Scene scene = plain(2);
  EXPECT_THROW(draw_svg(scene, {{0, 0, 0}}, {}), std::invalid_argument);
  EXPECT_THROW(draw_svg(scene, starts(scene), {{0, 2}}), std::invalid_argument);
  EXPECT_THROW(draw_svg(scene, starts(scene), {}, {.size = 0}), std::invalid_argument);
  try {
    draw_svg(scene, {{0, 0, 0}, {0, std::numeric_limits<double>::infinity(), 0}}, {});
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "draw: particle 1 has the coordinate inf; only finite ones can be drawn");
  }
}

}  // namespace
}  // namespace tps
