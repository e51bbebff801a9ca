#include <algorithm>
#include <cmath>

#include "properties/conform/drawing.hpp"
#include "properties/conform/picture.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::properties::conform {
namespace {

/// Seen along z.
Point flat(const Vec& x) {
  return {x.at(0), x.at(1)};
}
Point sum(const Point& a, double s, const Point& b) {
  return {a.x + s * b.x, a.y + s * b.y};
}

/// The centre of all, and how far they are from it.
struct View {
  Point centre{0, 0};
  double reach = 0;

  explicit View(const std::vector<Vec>& places) {
    for (const Vec& x : places) centre = sum(centre, 1.0 / static_cast<double>(places.size()), flat(x));
    for (const Vec& x : places) reach = std::max({reach, std::fabs(of(x).x), std::fabs(of(x).y)});
  }
  Point of(const Vec& x) const { return sum(flat(x), -1, centre); }
  bool can_be_drawn() const { return std::isfinite(reach) && reach > 0; }
};

Vec vector_in(const Json& value) {
  const auto numbers = numbers_of(value);
  return numbers && numbers->size() >= 2 ? *numbers : Vec{NAN, NAN};
}

/// Lines of a length that shows, from each place.
void velocities(Picture& picture, const View& view, const std::vector<Vec>& places,
                const std::vector<Vec>& speeds, const char* style) {
  double fastest = 0;
  for (const Vec& v : speeds) fastest = std::max(fastest, std::hypot(v[0], v[1]));
  if (!(fastest > 0) || !std::isfinite(fastest)) return;
  for (std::size_t n = 0; n < std::min(places.size(), speeds.size()); ++n) {
    const Point from = view.of(places[n]);
    picture.line(from, sum(from, 0.4 * view.reach / fastest, flat(speeds[n])), style);
  }
}

/// Velocities in a list, or in a row as known answers have them.
std::vector<Vec> rows(const Json& list, std::size_t count, std::size_t dimension) {
  const auto numbers = numbers_of(list);
  std::vector<Vec> all;
  if (!numbers || numbers->size() != count * dimension) return all;
  for (std::size_t n = 0; n < count; ++n)
    all.emplace_back(numbers->begin() + static_cast<std::ptrdiff_t>(n * dimension),
                     numbers->begin() + static_cast<std::ptrdiff_t>((n + 1) * dimension));
  return all;
}

}  // namespace

std::string drawing_of_group(const Json& in, const Json& found, const Json& right) {
  std::vector<Vec> places;
  for (const Json& body : in.at("bodies")) places.push_back(vector_in(body.at("u")));
  const View view(places);
  if (!view.can_be_drawn()) return {};
  Picture picture(1.4 * view.reach);
  for (const Json& c : in.at("collisions")) {
    picture.line(view.of(places.at(c.at("i").get<std::size_t>())),
                 view.of(places.at(c.at("j").get<std::size_t>())), "limit");
  }
  const std::size_t count = places.size(), dimension = places.front().size();
  for (const char* key : {"loaded", "restituted"}) {
    if (!found.contains(key) && !right.contains(key)) continue;
    velocities(picture, view, places, rows(found.value(key, Json()), count, dimension), "found");
    velocities(picture, view, places, rows(right.value(key, Json()), count, dimension), "right");
  }
  for (std::size_t n = 0; n < count; ++n) picture.dot(view.of(places[n]), "body", fmt::format("{}", n));
  return picture.svg();
}

std::string drawing_of_scene(const Json& scene, const Json& found, const Json& right) {
  std::vector<Vec> places, speeds;
  for (const Json& particle : scene.at("particles")) {
    places.push_back(vector_in(particle.at("position")));
    speeds.push_back(vector_in(particle.value("velocity", Json())));
  }
  const View view(places);
  if (!view.can_be_drawn()) return {};
  Picture picture(1.4 * view.reach);
  velocities(picture, view, places, speeds, "path");
  const auto takes_part = [](const Json& event, const Json& id) {
    return event.is_object() && (event.value("i", Json()) == id || event.value("j", Json()) == id);
  };
  for (std::size_t n = 0; n < places.size(); ++n) {
    const Json& particle = scene.at("particles").at(n);
    const Json id = particle.value("id", Json(n));
    const Json& species = scene.at("species").at(particle.at("species").get<std::string>());
    const auto radius = numbers_of(species.value("radius", Json(0)));
    if (radius && std::isfinite(radius->at(0))) picture.circle(view.of(places[n]), radius->at(0), "limit");
    const char* style = takes_part(found, id) ? "found" : takes_part(right, id) ? "right" : "body";
    picture.dot(view.of(places[n]), style, json_text(id));
  }
  return picture.svg();
}

}  // namespace tps::properties::conform
