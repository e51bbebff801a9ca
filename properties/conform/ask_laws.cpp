#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <memory>

#include "properties/check_law.hpp"
#include "properties/conform/inquiry.hpp"
#include "properties/conform/takes.hpp"
#include "properties/explore/report.hpp"
#include "properties/implementations/reference.hpp"
#include "reference/process/interrupt.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::properties::conform {
namespace {

using Clock = std::chrono::steady_clock;
using Kind = Outcome::Kind;

/// After so many broken cases of a law the others would say the same.
constexpr int kMostBroken = 10;
/// Hands on, sees what kind of answers come, and gives up at a moment, which ends shrinking.
class Watched final : public Implementation {
 public:
  Watched(Implementation& subject, const std::vector<Op>& offered) : subject_(subject) {
    for (const Op op : offered) offered_.emplace_back(operations::name(op));
  }
  std::string name() const override { return subject_.name(); }
  Format format() const override { return subject_.format(); }
  std::optional<std::vector<std::string>> offered() const override { return offered_; }
  std::string given_up() const override {
    return end && Clock::now() > *end ? "the time for shrinking is over" : subject_.given_up();
  }
  Answer ask(const Question& question) override {
    if (!takes(subject_.features(), question)) {
      untaken = true;
      return {Answer::Status::skipped, {}, "it does not take such questions"};
    }
    Answer answer = subject_.ask(question);
    if (answer.status == Answer::Status::failed) failed_at = question;
    times_alone = times_alone ||
                  (answer.out.is_object() && answer.out.contains("t") && !answer.out.contains("verdict"));
    return answer;
  }

  std::optional<Question> failed_at;  ///< a crash, a hang, a breach of the protocol
  bool untaken = false;               ///< a question that the features of hello exclude
  bool times_alone = false;           ///< a time without a verdict, which laws need
  std::optional<Clock::time_point> end;

 private:
  Implementation& subject_;
  std::vector<std::string> offered_;
};

class Laws {
 public:
  Laws(Implementation& subject, const Plan& plan, Verdict& verdict)
      : subject_(subject),
        plan_(plan),
        verdict_(verdict),
        stable_(reference(subject.format().bits <= 24 ? "float" : "double")) {
    for (const operations::Operation& operation : operations::catalogue()) {
      if (!wanted(plan_.ops, std::string(operation.name))) continue;
      wanted_.push_back(operation.op);
      if (is_offered(subject_, verdict_, operation.op)) asked_.push_back(operation.op);
    }
  }

  void ask() {
    for (const Law& law : laws()) {
      if (plan_.stops() || !subject_.given_up().empty()) return;
      if (can_be_asked(law, [this](Op op) { return is_in(asked_, op); })) {
        ask(law);
      } else if (can_be_asked(law, [this](Op op) { return is_in(wanted_, op); })) {
        note_not_asked(law);
      }
    }
  }

 private:
  static bool is_in(const std::vector<Op>& list, Op op) {
    return std::find(list.begin(), list.end(), op) != list.end();
  }

  void note_not_asked(const Law& law) {
    std::vector<std::string> needs;
    for (const Op op : law.operations) {
      if (!is_in(asked_, op)) needs.emplace_back(operations::name(op));
    }
    if (law.is_of_each) needs = {fmt::format("{}", fmt::join(needs, " or "))};
    verdict_.laws_not_asked.push_back({std::string(law.text.number), std::move(needs)});
  }

  void ask(const Law& law) {
    plan_.progress(law.text.id);
    Row row{std::string(operations::operation(law.operations.front()).part), law.text.id, "laws",
            law.text.number, law.text.page};
    Class worst = Class::right;
    int broken = 0;
    std::optional<std::uint64_t> to_shrink;
    for (std::uint64_t n = 0; n < plan_.law_cases && broken < kMostBroken; ++n) {
      if (plan_.stops() || !subject_.given_up().empty()) break;
      Watched watched(subject_, asked_);
      const Examined found = examine(law, watched, generated_case(law, subject_.format(), plan_.seed, n));
      if (watched.untaken) continue;
      if (found.outcome.kind == Kind::skipped) {
        verdict_.laws_not_asked.push_back(
            {std::string(law.text.number), {std::string(operations::name(found.questions.back().op))}});
        return;
      }
      if (watched.failed_at) {
        verdict_.note_failure({fmt::format("{}, case {}", law.text.id, n), found.outcome.why,
                               plan_.commands_of(*watched.failed_at)});
      }
      // A program that gives times alone is judged by known answers.
      const bool is_content =
          found.outcome.kind == Kind::failed && !watched.failed_at && !watched.times_alone;
      if (found.outcome.kind == Kind::outside || (found.outcome.kind == Kind::failed && !is_content))
        continue;
      const Grade grade = graded(found);
      if (found.outcome.kind == Kind::broken || is_content) {
        ++broken;
        if (grade.which > worst) to_shrink = n;
      }
      worst = std::max(worst, grade.which);
      row.add(grade, [&] { return example(law, n, found); });
    }
    if (to_shrink) shrink(law, *to_shrink, row.examples[index_of(worst)]);
    if (row.asked() > 0) verdict_.rows.push_back(std::move(row));
  }

  static Example example(const Law& law, std::uint64_t n, const Examined& found) {
    Example made{Class::right,
                 fmt::format("{}, case {}", law.text.id, n),
                 std::string(law.text.sentence) + ": " + found.outcome.why,
                 {},
                 {}};
    for (const Question& question : found.questions) made.commands.push_back(command_of(question));
    if (!found.questions.empty()) made.in = json_text(found.questions.back().in);
    return made;
  }

  Grade graded(const Examined& found) {
    switch (found.outcome.kind) {
      case Kind::holds:
        return {};
      case Kind::rounding:
        return {Class::not_bitwise, found.outcome.why};
      case Kind::refused:
        return {std::all_of(found.questions.begin(), found.questions.end(),
                            [&](const Question& q) { return !leaves_range(q, subject_.format()); })
                    ? Class::refused
                    : Class::worse,
                found.outcome.why};
      default:
        return {class_of_broken(found), found.outcome.why};
    }
  }

  /// A law is broken by the worst of the answers that it was given: also by one that is right but for its
  /// name. Where each of them alone is right, or rounding may decide it, they do not fit together: that is
  /// wrong, since laws leave to rounding what is its.
  Class class_of_broken(const Examined& found) {
    Class worst = Class::right;
    for (const Question& question : found.questions) {
      if (const auto known = certified(question)) {
        worst = std::max(worst, grade(*known, subject_.ask(question), subject_.format(), *stable_).which);
      }
    }
    return worst == Class::other_reading || worst > Class::beyond ? worst : Class::wrong;
  }

  static std::optional<KnownQuestion> certified(const Question& question) {
    try {
      KnownQuestion known{{}, {}, question, vectors::known_answer(question.op, question.in)};
      known.answer["accept"] = vectors::accepted_by(question.op);
      return known;
    } catch (const std::exception&) {
      return std::nullopt;  // no operation of known answers, or a question that has none
    }
  }

  /// The shrunk case takes the place of the example, where there is time.
  void shrink(const Law& law, std::uint64_t n, std::optional<Example>& shown) {
    const Clock::time_point start = Clock::now();
    const auto left = std::chrono::duration<double>(plan_.shrink_seconds - spent_);
    Watched hurried(subject_, asked_);
    hurried.end = start + std::chrono::duration_cast<Clock::duration>(left);
    if (!shown || !hurried.given_up().empty()) return;
    plan_.progress(law.text.id + std::string(": making its case simpler"));
    Tally tally;
    Extent extent{plan_.seed, n, 1};
    const auto finding = check_law(law, hurried, extent, tally);
    spent_ += std::chrono::duration<double>(Clock::now() - start).count();
    if (!finding || finding->shrinks == 0) return;
    const Class which = shown->which;
    const Examined shrunk{finding->outcome, finding->questions};
    if (graded(shrunk).which != which) return;  // a simpler case of another kind says something else
    shown = example(law, n, shrunk);
    shown->which = which;
    shown->id += fmt::format(", shrunk {} times", finding->shrinks);
  }

  Implementation& subject_;
  const Plan& plan_;
  Verdict& verdict_;
  std::unique_ptr<Implementation> stable_;
  std::vector<Op> wanted_,
      asked_;         ///< operations that --ops selects; of them those that are offered
  double spent_ = 0;  ///< on shrinking, in seconds
};

}  // namespace

void ask_laws(Implementation& subject, const Plan& plan, Verdict& verdict) {
  Laws(subject, plan, verdict).ask();
}

}  // namespace tps::properties::conform
