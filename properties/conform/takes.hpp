// What a program says of the questions that it takes: the features of hello (docs/protocol.md).
#pragma once

#include <string>
#include <vector>

#include "properties/implementation.hpp"

namespace tps::properties::conform {

/// Whether a question has nothing that the features exclude: "2d" space, "3d" the plane, "no-infinite-masses"
/// a mass of "inf", "no-tethers" a scene with tethers or laws of tethering. The others are of whole runs.
bool takes(const std::vector<std::string>& features, const Question& question);

}  // namespace tps::properties::conform
