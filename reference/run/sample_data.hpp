// Samples of clusters as a full state keeps them (docs/trace.md, "Full states").
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reference/engine/state_data.hpp"
#include "reference/engine/state_numbers.hpp"
#include "reference/run/run.hpp"

namespace tps {

inline std::vector<Hex> sample_data(const ClusterSample& s) {
  std::vector<Hex> data = {s.occasion,
                           to_hex(s.t),
                           std::to_string(s.described),
                           to_hex(s.extent),
                           to_hex(s.relative_speed),
                           to_hex(s.centre_speed),
                           std::to_string(s.particles),
                           to_hex(s.mass)};
  for (const double component : s.centre_velocity) data.push_back(to_hex(component));
  for (const int size : s.sizes) data.push_back(std::to_string(size));
  return data;
}

inline ClusterSample sample_from(const std::vector<Hex>& data) {
  using detail::number_from;
  ClusterSample s;
  s.occasion = data.at(0);
  s.t = number_from<double>(data.at(1));
  s.described = std::stoi(data.at(2));
  s.extent = number_from<double>(data.at(3));
  s.relative_speed = number_from<double>(data.at(4));
  s.centre_speed = number_from<double>(data.at(5));
  s.particles = std::stoi(data.at(6));
  s.mass = number_from<double>(data.at(7));
  for (std::size_t k = 0; k < 3; ++k) s.centre_velocity[k] = number_from<double>(data.at(8 + k));
  for (std::size_t n = 11; n < data.size(); ++n) s.sizes.push_back(std::stoi(data[n]));
  return s;
}

}  // namespace tps
