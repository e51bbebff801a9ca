// Variants in Boost's binary floats: what is bought with digits alone.
#include <limits>

#include "reference/scalars.hpp"
#include "verify/cost/reference_formulas.hpp"
#include "verify/cost/variant_lists.hpp"
#include "verify/cost/variant_of.hpp"

namespace tps::cost {
namespace {

template <typename Scalar>
void add(std::vector<Variant>& to) {
  const std::string arithmetic(scalar_name<Scalar>);
  constexpr int bits = std::numeric_limits<Scalar>::digits;
  to.push_back(variant_of<printed_time<Scalar>>("printed", arithmetic, bits));
  to.push_back(variant_of<stable_time<Scalar>>("stable", arithmetic, bits));
}

}  // namespace

void add_wide_variants(std::vector<Variant>& to) {
  add<Quad>(to);
  add<Mp50>(to);
  add<Mp100>(to);
}

}  // namespace tps::cost
