// One entry of the key "walls" of a scene.
#pragma once

#include <functional>
#include <string>

#include "reference/scene/scene.hpp"
#include "reference/text/json_document.hpp"

namespace tps {

/// Reads a vector of the scene's dimension, and reports one that has another.
using ReadVector = std::function<Coordinates(const JsonValue& value, const std::string& pointer)>;

/// Whether an entry names no more than one of "plane", "sphere" and "box".
bool has_one_shape(const JsonValue& entry);

/// REQUIRES an entry that the schema has accepted, of one shape.
Wall read_wall(const JsonValue& entry, const std::string& pointer, const ReadVector& read_vector);

}  // namespace tps
