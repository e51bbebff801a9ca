// The oracles against certified answers: where they agree, and, as data, where each is known to be wrong.
#include "verify/oracles/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <map>
#include <string>

#include "tests/oracles/recorded_failures.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/oracles/gsl_quadratic.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::oracles {
namespace {

/// The time in which the pair would cross L: what an error of a time near 0 is measured by.
double natural_time(const TimingQuery& query) {
  double fastest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    fastest = std::max(fastest, std::fabs(query.v_B[k] / 2 - query.v_A[k] / 2));
  }
  return query.L / (2 * fastest);
}

/// How an oracle's answers to a stratum differ from the certified ones.
Failures failures(const Oracle& oracle, const exact::strata::Stratum& stratum) {
  Failures found{std::string(oracle.name), stratum.name, 0, 0};
  for (const TimingQuery& query : stratum.queries) {
    exact::Counters counters;
    const std::optional<double> certified = exact::rounded_time(query, counters).t;
    const std::optional<double> answer = oracle.time(query);
    if (certified.has_value() != answer.has_value()) {
      ++found.existence;
    } else if (certified && *certified != *answer) {
      const double error = std::fabs(*certified - *answer);
      // Lost means fewer than 20 bits: a minimum found from values alone, as Brent's bracket is, has
      // about 26. NaN is a lost answer, too.
      if (!(error <= 0x1p-20 * std::max(*certified, natural_time(query)))) ++found.time;
    }
  }
  return found;
}

TEST(Oracles, FailuresAreTheRecordedOnes) {
  std::map<std::pair<std::string, std::string>, Failures> recorded;
  for (const Failures& row : recorded_failures) recorded[{row.oracle, row.stratum}] = row;
  for (const Oracle& oracle : all_oracles()) {
    for (const exact::strata::Stratum& stratum : exact::strata::all(20260104, 200)) {
      const Failures found = failures(oracle, stratum);
      const Failures expected = recorded[{found.oracle, found.stratum}];
      EXPECT_TRUE(found.existence == expected.existence && found.time == expected.time)
          << "{\"" << found.oracle << "\", \"" << found.stratum << "\", " << found.existence << ", "
          << found.time << "},";
    }
  }
}

// With enough digits the textbook formula and the certified path give the same double, bit for bit.
TEST(Oracles, HundredDigitsAgreeToTheLastBit) {
  for (const exact::strata::Stratum& stratum : exact::strata::all(20260105, 300)) {
    if (stratum.name == "wide") continue;  // spans 4,000 bits
    for (const TimingQuery& query : stratum.queries) {
      exact::Counters counters;
      EXPECT_EQ(time_in_100_digits(query), exact::rounded_time(query, counters).t)
          << exact::strata::text(query);
    }
  }
}

/// The number of real roots of A x² + B x + C, exactly.
int real_roots(double A, double B, double C) {
  using Rational = boost::multiprecision::cpp_rational;
  const Rational discriminant = Rational(B) * Rational(B) - 4 * Rational(A) * Rational(C);
  return discriminant > 0 ? 2 : discriminant < 0 ? 0 : 1;
}

/// GSL counts a double root as two.
bool gsl_counts_wrongly(double A, double B, double C) {
  const int expected = real_roots(A, B, C);
  return gsl_quadratic_roots(A, B, C).count != (expected == 1 ? 2 : expected);
}

// F(n) x² − 2F(n−1) x + F(n−2): a quarter of the discriminant is (−1)^n, however large the coefficients.
TEST(Oracles, GslOnFibonacciQuadratics) {
  std::vector<int> wrong;
  double before = 1;
  double last = 1;
  for (int n = 3; n <= 78; ++n) {  // F(78) is the last below 2^53
    const double next = before + last;
    if (gsl_counts_wrongly(next, -2 * last, before)) wrong.push_back(n);
    before = last;
    last = next;
  }
  EXPECT_EQ(wrong, recorded_fibonacci);
}

// n x² − 2(n+1) x + (n+2): the roots are 1 and 1 + 2/n, a quarter of the discriminant is 1. Kahan's cases are
// of this kind; from n ≈ 2^26 on B² − 4AC is rounded to 0, 4 or 8.
TEST(Oracles, GslOnConsecutiveCoefficients) {
  const auto roots = [](double n) { return gsl_quadratic_roots(n, -2 * (n + 1), n + 2); };
  EXPECT_EQ(roots(1000).smaller, 1);
  EXPECT_LT(roots(94906266.375).smaller, 1 - 4e-9);
  EXPECT_EQ(roots(0x1p40).smaller, roots(0x1p40).larger);
  // Kahan's other case: the discriminant's quarter is 121/64, and GSL sees a double root.
  const RealRoots kahan = gsl_quadratic_roots(94906265.625, -2 * 94906267.0, 94906268.375);
  EXPECT_EQ(kahan.smaller, kahan.larger);
}

// x² − 3x + 2 in other units, and x² − 3x + 3 without roots: B² overflows or underflows, the roots do not.
TEST(Oracles, GslOutOfRange) {
  EXPECT_EQ(gsl_quadratic_roots(1, -3, 2).larger, 2);
  EXPECT_EQ(gsl_quadratic_roots(1, -3 * 0x1p600, 0x1p1001).larger, HUGE_VAL);
  EXPECT_EQ(gsl_quadratic_roots(0x1p-600, -3 * 0x1p-600, 0x1p-599).larger, 1.5);
  EXPECT_TRUE(gsl_counts_wrongly(0x1p-600, -3 * 0x1p-600, 3 * 0x1p-600));
}

}  // namespace
}  // namespace tps::oracles
