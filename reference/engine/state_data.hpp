// A full state as text holds it: ids and hexadecimal floats, whatever the scalar. Between the state lines of
// a trace (or a checkpoint) and the engine's own types.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace tps {

using Hex = std::string;             ///< a number, exactly
using HexVector = std::vector<Hex>;  ///< one per dimension
using HexTime = std::array<Hex, 2>;  ///< hi and lo of a Time, their sum being the time since the start

/// The place of a particle in the scene by its id.
using IndexOfId = std::unordered_map<std::int32_t, int>;

struct StateData {
  struct Particle {
    std::int32_t id = 0;
    HexVector position, velocity;
    HexTime clock;
    HexVector spin = {};  ///< of those that keep one
  };
  struct Responded {
    std::int32_t first = 0, second = 0;
    bool outer = false;
  };
  /// A side of a node: another node of the same group (index), a particle (id), or neither for an infinite
  /// mass.
  struct Side {
    std::optional<int> node;
    std::optional<std::int32_t> particle;
  };
  struct Node {
    std::int32_t i = 0, j = 0;
    bool outer = false;
    std::array<Side, 2> sides;
    std::array<Hex, 2> masses;
    HexVector dp;
  };
  struct Group {
    std::vector<std::int32_t> members;
    Hex mass;
    HexTime expiry, birth;
    std::vector<Node> nodes;  ///< the first one is the root
  };
  struct Draws {
    int purpose = 0;
    std::int32_t first = 0, second = 0;
    std::uint32_t used = 0;
  };

  /// What a line says of its own integrity.
  enum class Checksum {
    absent,  ///< written before there were checksums, or by another program: nothing protects it
    right,
    wrong,  ///< the content is not what was written
  };

  Checksum checksum = Checksum::absent;  ///< found by reading
  Hex t;                                 ///< of `now` on the scene's clock; found by reading
  std::uint64_t k = 0;                   ///< events so far
  bool final = false;                    ///< written at the end of a run, not because K events had passed
  HexTime now, last_event;
  std::uint64_t progress_event = 0;
  std::vector<Particle> particles;
  std::vector<std::array<std::int32_t, 2>> tethers;
  std::vector<Responded> responded;
  std::vector<Group> groups;
  std::vector<Draws> draws;
  std::map<std::string, std::uint64_t> progress;  ///< of the effects with events known in advance
  std::map<std::string, std::uint64_t> counts;    ///< of the summary
  std::map<std::string, HexVector> quantities;    ///< of the summary and the ledger
  std::vector<std::vector<Hex>> observations;     ///< of clusters, one a sample
};

}  // namespace tps
