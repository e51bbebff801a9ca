// What a simulator seems to lack: a thing that every scene at which it fails has.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps::properties::conform {

class FeatureHint {
 public:
  /// Words of --features that were given are not proposed again.
  explicit FeatureHint(std::vector<std::string> features) : features_(std::move(features)) {}

  void add(const Scene& scene, bool fails);

  /// The fewest words (by the largest share of what is left) without which no scene fails, in a sentence.
  /// Nothing where some scene fails without all that can be left out, or none passes without what is named.
  std::optional<std::string> words() const;

 private:
  struct Asked {
    std::vector<bool> has;  ///< of each thing
    bool fails;
  };

  std::vector<std::string> features_;
  std::vector<Asked> scenes_;
};

}  // namespace tps::properties::conform
