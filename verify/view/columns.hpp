// The numbers of a playback as a page reads them: one array a column, all in one block of bytes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "verify/view/playback.hpp"

namespace tps::view {

/// Little-endian columns of doubles ("f64"), 32-bit integers ("i32") and bytes ("u8"), each from a multiple
/// of eight bytes on. Vectors are of the scene's dimension, one after another.
class Columns {
 public:
  explicit Columns(const Playback& playback);

  const std::string& bytes() const { return bytes_; }
  /// {"event_t":{"type":"f64","from":0,"length":70},…}: bytes, then numbers.
  const nlohmann::ordered_json& places() const { return places_; }

 private:
  template <typename Number, typename Rows, typename Of>
  void column(std::string_view name, const Rows& rows, Of of);
  template <typename Rows, typename Of>
  void vectors(std::string_view name, const Rows& rows, Of of, int dimension);
  void start(std::string_view name, std::string_view type, std::size_t length);

  std::string bytes_;
  nlohmann::ordered_json places_;
};

}  // namespace tps::view
