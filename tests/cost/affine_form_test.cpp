// Affine arithmetic keeps its law: for any values of the symbols the result holds the true result.
#include "verify/cost/affine_form.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "verify/vectors/random.hpp"

namespace tps::cost {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_100;
constexpr long kBits = 128;  ///< of the forms, 334 of the truth

/// A form and the number that it stands for where the symbols have the values of a sample.
struct Sample {
  AffineForm form;
  Wide truth;
};

class AffineLaw : public testing::TestWithParam<int> {
 protected:
  AffineLaw() : random_(static_cast<std::uint64_t>(GetParam())) {
    for (double& value : values_) value = random_.integer(0, 3) == 0 ? -1 : random_.uniform(-1, 1);
  }

  /// Centre in [1, 8), up to six of the symbols with factors of 2^-40 to 2^-2 of it all together.
  Sample sample() {
    const double centre = random_.uniform(1, 8);
    Sample result{AffineForm(centre, kBits), Wide(centre)};
    const double size = std::ldexp(centre, -random_.integer(2, 40)) / kSymbols;
    for (std::uint32_t symbol = 1; symbol <= kSymbols; ++symbol) {
      if (random_.integer(0, 2) == 0) continue;
      const double factor = random_.uniform(0, size);
      result.form.widen(factor, symbol);
      result.truth += Wide(factor) * Wide(values_[symbol - 1]);
    }
    return result;
  }

  void expect_holds(const AffineForm& form, const Wide& truth, const char* what) const {
    AffineForm at = form;
    for (std::uint32_t symbol = 1; symbol <= kSymbols; ++symbol) at = at.given(symbol, values_[symbol - 1]);
    EXPECT_LE(Wide(at.lower()), truth) << what;
    EXPECT_GE(Wide(at.upper()), truth) << what;
    EXPECT_LE(form.lower(), at.lower()) << what;
    EXPECT_GE(form.upper(), at.upper()) << what;
  }

  static constexpr std::uint32_t kSymbols = 6;
  vectors::Random random_;
  double values_[kSymbols];
};

TEST_P(AffineLaw, HoldsForEveryOperation) {
  for (int n = 0; n < 200; ++n) {
    const Sample x = sample(), y = sample(), z = sample();
    expect_holds(x.form + y.form, x.truth + y.truth, "sum");
    expect_holds(x.form - y.form, x.truth - y.truth, "difference");
    expect_holds(x.form * y.form, x.truth * y.truth, "product");
    expect_holds(inverse(x.form), 1 / x.truth, "inverse");
    expect_holds(sqrt(x.form), sqrt(x.truth), "root");
    AffineForm long_one = (x.form * y.form - z.form) * inverse(sqrt(z.form)) + x.form;
    const Wide truth = (x.truth * y.truth - z.truth) / sqrt(z.truth) + x.truth;
    expect_holds(long_one, truth, "an expression");
    long_one.absorb(kSymbols + 1);
    expect_holds(long_one, truth, "what was absorbed");
    expect_holds(long_one.alone(), truth, "without symbols");
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, AffineLaw, testing::Range(1, 4));

/// What plain intervals cannot: of x − x nothing is left but what rounding of factors may do, and a product
/// errs by its second order alone.
TEST(AffineForm, KnowsWhatCancels) {
  AffineForm x(3, kBits);
  x.widen(0x1p-20, 1);
  EXPECT_LE((x - x).upper(), 0x1p-70);
  const AffineForm left = x * x - (AffineForm(6, kBits) * x - AffineForm(9, kBits));  // (x − 3)²
  EXPECT_LE(left.upper(), 0x1p-39);
  EXPECT_GE(left.lower(), -0x1p-39);
  EXPECT_GT((x.alone() - x.alone()).upper(), 0x1p-20);
}

TEST(AffineForm, TellsTheSignOnlyWhereItIsCertain) {
  AffineForm x(1, kBits);
  EXPECT_EQ(x.sign(), CertainSign::positive);
  EXPECT_EQ((-x).sign(), CertainSign::negative);
  x.widen(1, 1);
  EXPECT_EQ(x.sign(), CertainSign::unknown);
  EXPECT_EQ(AffineForm(0, kBits).sign(), CertainSign::zero);
}

/// tan 45° = 1, cos 60° = 1/2, (1/2)^(90/180) = 1/√2.
TEST(AffineForm, HoldsTheConstantsOfEquation5) {
  const auto expect_about = [](const AffineForm& form, double value) {
    EXPECT_LE(form.lower(), value);
    EXPECT_GE(form.upper(), value);
    EXPECT_LE(form.upper() - form.lower(), 0x1p-50);
  };
  expect_about(tan_degrees(45, kBits), 1);
  expect_about(cos_degrees(60, kBits), 0.5);
  expect_about(speed_ratio(0.5, 90, kBits) * speed_ratio(0.5, 90, kBits), 0.5);
}

}  // namespace
}  // namespace tps::cost
