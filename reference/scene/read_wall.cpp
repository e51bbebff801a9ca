#include "reference/scene/read_wall.hpp"

#include "reference/scene/scene_values.hpp"

namespace tps {
bool has_one_shape(const JsonValue& entry) {
  int shapes = 0;
  for (const char* key : {"plane", "sphere", "box"}) shapes += entry.find(key) != nullptr ? 1 : 0;
  return shapes == 1;
}

Wall read_wall(const JsonValue& entry, const std::string& pointer, const ReadVector& read_vector) {
  Wall wall;
  const auto vector = [&](const JsonValue& shape, const char* name, const char* key) {
    return read_vector(*shape.find(key), pointer + "/" + name + "/" + key);
  };
  if (const JsonValue* plane = entry.find("plane")) {
    wall.point = vector(*plane, "plane", "through");
    wall.normal = vector(*plane, "plane", "normal");
  }
  if (const JsonValue* sphere = entry.find("sphere")) {
    wall.shape = Wall::Shape::sphere;
    wall.point = vector(*sphere, "sphere", "centre");
    wall.radius = number_at(*sphere, "radius");
    wall.inside = *sphere->find("side")->string() == "inside";
  }
  if (const JsonValue* box = entry.find("box")) {
    wall.shape = Wall::Shape::box;
    wall.point = vector(*box, "box", "low");
    wall.high = vector(*box, "box", "high");
    const JsonValue* side = box->find("side");
    wall.inside = side == nullptr || *side->string() == "inside";
  }
  wall.c_rebound = number_at(entry, "c_rebound");
  if (const JsonValue* velocity = entry.find("velocity"))
    wall.velocity = read_vector(*velocity, pointer + "/velocity");
  return wall;
}

}  // namespace tps
