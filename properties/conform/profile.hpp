// Profiles: which classes fail, and in which numbers answers are given.
#pragma once

#include <string>
#include <vector>

#include "properties/conform/verdict.hpp"

namespace tps::properties::conform {

/// certified: everything but RIGHT fails. double-stable: ROUNDING, NOT BITWISE, OTHER READING and BEYOND ITS
/// PRECISION pass. double-paper: so does WORSE THAN STABLE; float: the same, in 24 bits. Without a name:
/// double-paper in the bits of the subject.
std::vector<std::string> profile_names();

bool is_built_in(const std::string& profile);

/// A profile by its name, or of a file: {"conform_profile":1,"name","fails":[class, …],"bits"?}. Throws
/// InputError.
Profile read_profile(const std::string& name_or_file);

}  // namespace tps::properties::conform
