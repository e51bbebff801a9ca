// Where in its file each part of a scene stands, and what is wrong there.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/json_pointer.hpp"

namespace tps {

/// A scene's JSON value and the problems found in it.
class SceneSource {
 public:
  SceneSource(const JsonValue& root, std::string prefix, InputProblems& problems)
      : root_(root), prefix_(std::move(prefix)), problems_(problems) {}

  const JsonValue& root() const { return root_; }

  /// Reports a problem at a JSON pointer that counts from the scene.
  void report(const std::string& pointer, std::string message) {
    problems_.add(line(pointer), prefix_ + pointer, std::move(message));
  }

  /// Line of the value at `pointer`, or of the innermost one around it that the file has.
  std::size_t line(const std::string& pointer) const { return resolve_pointer(root_, pointer).line; }

  /// Whether nothing is wrong with these keys of the scene so far, so that what was read from them is whole.
  bool sound(std::initializer_list<std::string_view> keys) const {
    for (const std::string_view key : keys) {
      std::string pointer = "/";
      pointer += key;
      if (!sound_at(pointer)) return false;
    }
    return true;
  }

  /// Whether nothing is wrong at `pointer`, which counts from the scene, or inside it.
  bool sound_at(const std::string& pointer) const { return !problems_.touches(prefix_ + pointer); }

  /// Whether so much is wrong that looking for more helps nobody.
  bool full() const { return problems_.full(); }

  /// Scene::particles[k] stands at /particles/N, N = particle_entries[k]: its place in a list, or its id
  /// where ids are keys.
  std::vector<std::size_t> particle_entries;

 private:
  const JsonValue& root_;
  std::string prefix_;
  InputProblems& problems_;
};

}  // namespace tps
