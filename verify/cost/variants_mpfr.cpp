// Variants in MPFR's binary floats: the same digits as in Boost's own, from the library that is known for
// them.
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <limits>

#include "verify/cost/reference_formulas.hpp"
#include "verify/cost/variant_lists.hpp"
#include "verify/cost/variant_of.hpp"

namespace tps::cost {
namespace {

namespace mp = boost::multiprecision;

/// Without expression templates, like the others, and on the stack: an allocation each would be what is
/// timed.
template <unsigned digits10>
using Mpfr = mp::number<mp::mpfr_float_backend<digits10, mp::allocate_stack>, mp::et_off>;

template <typename Scalar>
void add(std::vector<Variant>& to, const std::string& arithmetic) {
  constexpr int bits = std::numeric_limits<Scalar>::digits;
  to.push_back(variant_of<printed_time<Scalar>>("printed", arithmetic, bits));
  to.push_back(variant_of<stable_time<Scalar>>("stable", arithmetic, bits));
}

}  // namespace

void add_mpfr_variants(std::vector<Variant>& to) {
  add<Mpfr<50>>(to, "mpfr50");
  add<Mpfr<100>>(to, "mpfr100");
}

}  // namespace tps::cost
