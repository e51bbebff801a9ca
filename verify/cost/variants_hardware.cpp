// Variants in the scalars of the hardware.
#include <limits>

#include "verify/cost/formulas.hpp"
#include "verify/cost/reference_formulas.hpp"
#include "verify/cost/variant_lists.hpp"
#include "verify/cost/variant_of.hpp"

namespace tps::cost {
namespace {

template <typename Scalar>
void add(std::vector<Variant>& to, const std::string& arithmetic) {
  constexpr int bits = std::numeric_limits<Scalar>::digits;
  to.push_back(variant_of<printed_time<Scalar>>("printed", arithmetic, bits));
  to.push_back(variant_of<root_time<Scalar>>("root", arithmetic, bits));
  to.push_back(variant_of<scaled_time<Scalar>>("scaled", arithmetic, bits));
  to.push_back(variant_of<cross_time<Scalar>>("cross", arithmetic, bits));
  to.push_back(variant_of<kahan_time<Scalar>>("kahan", arithmetic, bits));
  to.push_back(variant_of<stable_time<Scalar>>("stable", arithmetic, bits));
}

}  // namespace

void add_hardware_variants(std::vector<Variant>& to) {
  add<float>(to, "float");
  add<double>(to, "double");
  add<long double>(to, "long-double");
  // Boost's solver computes floats in double.
  to.push_back(variant_of<boost_time<double>>("boost", "double", std::numeric_limits<double>::digits));
  to.push_back(
      variant_of<boost_time<long double>>("boost", "long-double", std::numeric_limits<long double>::digits));
}

}  // namespace tps::cost
