#include "verify/cost/variant.hpp"

#include <algorithm>

#include "verify/cost/variant_lists.hpp"

namespace tps::cost {
namespace {

std::size_t place_of(const std::string& formula) {
  const auto& all = formulas();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Formula& f) { return f.name == formula; });
  return static_cast<std::size_t>(found - all.begin());
}

}  // namespace

const std::vector<Formula>& formulas() {
  static const std::vector<Formula> all = {
      {"printed", "eq. (2) as printed: (-b -+ sqrt(b^2 - 4ac)) / 2a"},
      {"root", "the root that adds: c / (-h + sqrt(h^2 - ac))"},
      {"scaled", "the same, lengths and velocities scaled by powers of two first"},
      {"cross", "the same with D = a L^2 - |r x v|^2"},
      {"kahan", "the same with h^2 - ac by Kahan's algorithm (fma)"},
      {"gsl", "gsl_poly_solve_quadratic on a, b, c"},
      {"boost", "Boost.Math quadratic_roots on a, b, c"},
      {"stable",
       "the reference: D by the form that fits, c as a product near the limit, scaled where needed"},
      {"certified-verdict", "the verdict alone: doubles with bounds, double words, integers"},
      {"certified-time", "the certified verdict and the correctly rounded time"},
      {"rational-verdict", "the verdict alone, in rational numbers as the rule is written"},
      {"integers", "certified verdict and time by integers of a common unit alone"}};
  return all;
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all = [] {
    std::vector<Variant> list;
    add_hardware_variants(list);
    add_wide_variants(list);
    add_mpfr_variants(list);
    add_exact_variants(list);
    std::stable_sort(list.begin(), list.end(), [](const Variant& x, const Variant& y) {
      const std::size_t p = place_of(x.formula);
      const std::size_t q = place_of(y.formula);
      return p != q ? p < q : x.bits < y.bits;
    });
    const auto first =
        std::find_if(list.begin(), list.end(), [](const Variant& v) { return v.name == kBaseline; });
    std::rotate(list.begin(), first, first + 1);
    return list;
  }();
  return all;
}

}  // namespace tps::cost
