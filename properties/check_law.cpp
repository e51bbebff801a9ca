#include "properties/check_law.hpp"

#include <rapidcheck.h>

#include "properties/classify.hpp"
#include "properties/interview.hpp"
#include "reference/process/interrupt.hpp"

namespace tps::properties {
namespace {

/// RapidCheck's size: its generators grow with it up to this. Ours do not depend on it.
constexpr int kSize = 100;
/// Enough for any case of a few dozen numbers; a foreign program that hangs costs its timeout each.
constexpr int kMostShrinksTried = 20'000;
constexpr int kMostFailedShrinksTried = 40;

rc::Random stream(const Law& law, std::uint64_t seed, std::uint64_t number) {
  std::uint64_t purpose = 0xcbf29ce484222325U;  // FNV-1a
  for (const char letter : law.text.id)
    purpose = (purpose ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  return rc::Random(rc::Random::Key{seed, number, purpose, 0});
}

rc::Shrinkable<Case> draw(const Law& law, const Format& format, std::uint64_t seed, std::uint64_t number) {
  return law.cases(format)(stream(law, seed, number), kSize);
}

/// Descends to a simpler finding of the same kind as long as there is one.
void shrink(const Law& law, Implementation& subject, bool bitwise, rc::Seq<rc::Shrinkable<Case>> shrinks,
            Finding& finding) {
  const Outcome::Kind kind = finding.outcome.kind;
  int left = kind == Outcome::Kind::failed ? kMostFailedShrinksTried : kMostShrinksTried;
  for (auto next = shrinks.next(); next && left > 0; next = shrinks.next(), --left) {
    if (interrupt::requested() || !subject.given_up().empty()) return;
    const Case candidate = next->value();
    Examined found = examine(law, subject, candidate, bitwise);
    if (found.outcome.kind != kind) continue;
    finding.shrunk = candidate;
    finding.outcome = std::move(found.outcome);
    finding.questions = std::move(found.questions);
    ++finding.shrinks;
    shrinks = next->shrinks();
  }
}

}  // namespace

Case generated_case(const Law& law, const Format& format, std::uint64_t seed, std::uint64_t number) {
  return draw(law, format, seed, number).value();
}

Outcome judged(Outcome outcome, bool bitwise) {
  if (bitwise && outcome.kind == Outcome::Kind::rounding) outcome.kind = Outcome::Kind::broken;
  return outcome;
}

Examined examine(const Law& law, Implementation& subject, const Case& c, bool bitwise) {
  if (subject.offered() && !can_be_asked(law, [&](Op op) { return subject.may_offer(op); }))
    return {{Outcome::Kind::skipped, "what it needs is not among the ops of hello"}, {}};
  Interview interview(subject, c.dimension);
  Outcome outcome;
  try {
    outcome = law.check(interview, c);
  } catch (const Unanswered& none) {
    outcome = none.outcome;
  }
  return {judged(std::move(outcome), bitwise), interview.questions()};
}

std::optional<Finding> check_law(const Law& law, Implementation& subject, const Extent& extent, Tally& tally,
                                 const std::function<bool()>& stop) {
  const Format format = subject.format();
  std::optional<Finding> refusal;
  const auto found_at = [&](std::uint64_t number, const rc::Shrinkable<Case>& drawn, Examined found) {
    const Case c = drawn.value();
    Finding finding{&law, number, c, c, std::move(found.outcome), std::move(found.questions)};
    try {
      shrink(law, subject, extent.bitwise, drawn.shrinks(), finding);
    } catch (const interrupt::Interrupted&) {
      // as far as it got
    }
    return finding;
  };
  for (std::uint64_t number = extent.first; number < extent.first + extent.count; ++number) {
    if (stop() || !subject.given_up().empty()) break;
    const rc::Shrinkable<Case> drawn = draw(law, format, extent.seed, number);
    const Case c = drawn.value();
    Examined found = examine(law, subject, c, extent.bitwise);
    switch (found.outcome.kind) {
      case Outcome::Kind::rounding:
        if (tally.rounding++ == 0) tally.in_last_bits = found.outcome.why;
        [[fallthrough]];
      case Outcome::Kind::holds:
        ++tally.held;
        for (const std::string& hazard : hazards_of(c)) ++tally.hazards[hazard];
        break;
      case Outcome::Kind::outside:
        ++tally.outside;
        tally.why_not = found.outcome.why;
        break;
      case Outcome::Kind::skipped:
        ++tally.skipped;
        tally.why_not = found.outcome.why;
        return std::nullopt;  // an operation that is not offered will not be offered for the next case
      case Outcome::Kind::refused:
        if (tally.refused++ == 0) refusal = found_at(number, drawn, std::move(found));
        break;
      default:
        return found_at(number, drawn, std::move(found));
    }
  }
  return refusal;
}

}  // namespace tps::properties
