// How large the segments are in which a trace is judged.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tps::check {

/// Lines of a segment at least, so that taking up its first state costs little beside judging it.
inline constexpr std::uint64_t kLinesOfSegment = 16384;
/// Of a segment's lines, kept in memory where they come from a pipe.
inline constexpr std::size_t kBytesOfSegment = std::size_t{64} << 20U;

}  // namespace tps::check
