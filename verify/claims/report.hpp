// Claims as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "verify/claims/claim.hpp"

namespace tps::claims {

/// One line a figure: ok or FAIL, name, measured, expected, derivation.
std::string claims_text(const std::vector<Claim>& claims);
std::string claims_json(const std::vector<Claim>& claims);

}  // namespace tps::claims
