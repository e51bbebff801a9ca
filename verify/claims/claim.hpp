// What the paper states about its own simulations, as figures that a run either reproduces or does not.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tps::claims {

/// One number: what it must be and why, what runs gave.
struct Figure {
  std::string name;
  std::string expected;
  std::string derivation;  ///< where the expected value and its tolerance come from
  std::string measured;
  bool holds = false;
};

/// One statement of the paper with everything measured about it.
struct Claim {
  std::string name;
  std::string statement;  ///< in our words
  std::string source;     ///< section of the paper
  std::string command;    ///< a single run that shows it
  std::vector<Figure> figures;

  bool holds() const;
};

/// A claim that can be measured: `measure` runs the scenes, which takes seconds.
struct ClaimEntry {
  std::string name;
  std::string summary;
  std::function<Claim()> measure;
};

Claim collisions();
Claim stall();
Claim revolution();
Claim grouping();
Claim conservation();
Claim clusters();
Claim impact();

/// All of them, in the order of the paper.
const std::vector<ClaimEntry>& all_claims();

/// A count that must be exact.
Figure exactly(std::string name, long long expected, std::string derivation, long long measured);
/// A word that must be the same: how a run ended.
Figure same(std::string name, std::string expected, std::string derivation, std::string measured);
/// |measured − expected| <= tolerance; printed with `digits` significant digits.
Figure within(std::string name, double expected, double tolerance, std::string derivation, double measured,
              int digits);
/// least <= measured <= most; printed with `digits` significant digits.
Figure between(std::string name, double least, double most, std::string derivation, double measured,
               int digits);

}  // namespace tps::claims
