// The environment that a verdict is about: how numbers arrive, and what the processor does with them.
#pragma once

#include "properties/conform/verdict.hpp"
#include "properties/implementation.hpp"

namespace tps::properties::conform {

/// Asks a few questions whose answers tell: whether all bits of a number arrive, whether subnormal numbers
/// are flushed to zero, whether products are contracted to fused multiply-adds. What no operation of the
/// subject tells stays open. @return at what it fails, where it does; then nothing more is asked.
struct FailedProbe {
  std::string reason;
  Question question;
};
std::optional<FailedProbe> probe(Implementation& subject, Environment& environment);

}  // namespace tps::properties::conform
