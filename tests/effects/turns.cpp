// All that a program takes to have one more effect: linked with what the program `tps` is made of, this
// source makes it a program that runs, explains, records, checks and resumes turns.
#include "tests/effects/turns.hpp"

#include "tests/effects/turns_rules.hpp"

namespace tps {

const BringEffect<effects::turns, double> kTurns;
const check::BringRules<check::effects::turns, double> kRulesOfTurns;

}  // namespace tps
