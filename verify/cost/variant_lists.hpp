// The lists that variants() is put together from, one source each.
#pragma once

#include <vector>

#include "verify/cost/variant.hpp"

namespace tps::cost {

void add_hardware_variants(std::vector<Variant>& to);
void add_wide_variants(std::vector<Variant>& to);
void add_mpfr_variants(std::vector<Variant>& to);
void add_exact_variants(std::vector<Variant>& to);

}  // namespace tps::cost
