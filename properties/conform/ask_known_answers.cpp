#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>

#include "properties/conform/hypotheses.hpp"
#include "properties/conform/inquiry.hpp"
#include "properties/conform/probe.hpp"
#include "properties/conform/takes.hpp"
#include "properties/explore/report.hpp"
#include "properties/implementations/read_reply.hpp"
#include "properties/implementations/reference.hpp"
#include "reference/process/thread_time.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::properties::conform {
namespace {

/// The reference in the narrowest of its scalars that has these bits.
std::unique_ptr<Implementation> reference_in(const Format& format) {
  return reference(format.bits <= 24 ? "float" : format.bits <= 53 ? "double" : "long-double");
}

void note_numbers(const Json& value, Environment& environment) {
  if (value.is_structured()) {
    for (const Json& each : value) note_numbers(each, environment);
  } else if (value.is_string()) {
    if (const auto digits = split_hex(value.get_ref<const std::string&>()))
      environment.bits_seen = std::max(environment.bits_seen, significant_bits(*digits));
  } else if (value.is_number()) {
    environment.bits_seen =
        std::max(environment.bits_seen, significant_bits(hex_digits(value.get<double>())));
  }
}

/// The right numbers by their keys, as an answer has them.
Json nearest_of(const KnownQuestion& known) {
  Json right = Json::object();
  const Expected expected = expected_of(known).front();
  for (const ExpectedNumbers& numbers : expected.numbers) {
    Json list = Json::array();
    for (const ExpectedNumbers::End& end : numbers.ends) list.push_back(to_hex<double>(end.nearest));
    right[numbers.key] = numbers.key == "t" ? list.front() : list;
  }
  return right;
}

class KnownAnswers {
 public:
  KnownAnswers(Implementation& subject, const Plan& plan, Verdict& verdict)
      : subject_(subject), plan_(plan), verdict_(verdict), stable_(reference_in(subject.format())) {}

  void ask() {
    const Selection selection{plan_.level, [this](Op op) { return is_asked(op); },
                              [this](const std::string& name) { return wanted(plan_.strata, name); },
                              subject_.takes_outer_groups()};
    for_known_questions(selection, subject_.format(), [this](Stratum taken) {
      if (plan_.stops() || !subject_.given_up().empty()) return false;
      std::erase_if(taken.cases,
                    [this](const KnownQuestion& each) { return !takes(subject_.features(), each.question); });
      if (!taken.cases.empty() && offers(taken)) ask(taken);
      return true;
    });
  }

 private:
  /// Whether an operation is wanted, and not one of which the subject says that it lacks it.
  bool is_asked(Op op) {
    if (!wanted(plan_.ops, std::string(operations::name(op)))) return false;
    if (subject_.may_offer(op)) return true;
    lacks(op);
    return false;
  }

  /// A subject that does not say what it offers is known by its first answer.
  bool offers(const Stratum& stratum) {
    const auto known = offers_.find(stratum.op);
    if (known != offers_.end()) return known->second;
    const bool answers =
        subject_.offered() || subject_.ask(stratum.cases.front().question).status != Answer::Status::skipped;
    if (!answers) lacks(stratum.op);
    return offers_[stratum.op] = answers;
  }

  void lacks(Op op) {
    const std::string name(operations::name(op));
    if (!has(verdict_.not_offered, name)) verdict_.not_offered.push_back(name);
  }

  void ask(const Stratum& stratum) {
    Row row = row_of(stratum.op, stratum.name);
    plan_.progress(row.name);
    std::vector<Question> questions;
    for (const KnownQuestion& each : stratum.cases) questions.push_back(each.question);
    const auto start = std::chrono::steady_clock::now();
    const double computed = thread_seconds();  // another thread makes the next questions
    const std::vector<Answer> answers = subject_.ask_all(questions);
    verdict_.environment.cpu_seconds += thread_seconds() - computed;
    verdict_.environment.seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.reference = 0;
    const Answer* parent = nullptr;
    for (std::size_t n = 0; n < answers.size(); ++n) {
      const bool is_sibling = stratum.cases[n].is_sibling;
      if (!is_sibling) parent = &answers[n];
      judge(stratum.cases[n], answers[n], is_sibling ? parent : nullptr, row);
    }
    if (row.asked() > 0) verdict_.rows.push_back(std::move(row));
  }

  /// `parent`: the answer to the question that this one is a sibling of, if it is one.
  void judge(const KnownQuestion& known, const Answer& answer, const Answer* parent, Row& row) {
    if (answer.status == Answer::Status::failed)
      return verdict_.note_failure({known.id, answer.reason, plan_.commands_of(known.question)});
    note_numbers(answer.out, verdict_.environment);
    const Format format = subject_.format();
    const Grade found = grade(known, answer, format, *stable_);
    if (const auto score = reference_has(known, format); !score) {
      row.reference.reset();
    } else if (row.reference && *score) {
      ++*row.reference;
    }
    row.add(found, [&] {
      Example shown{found.which, known.id, {}, {command_of(known.question)}, json_text(known.question.in)};
      if (answer.status == Answer::Status::answered) {
        shown.found = json_text(answer.out);
        shown.right = json_text(nearest_of(known));
      }
      return shown;
    });
    if (found.which != Class::wrong) return;
    for (const std::string& name : hypotheses_fitting(known, answer.out)) ++row.hypotheses[name];
    if (parent != nullptr && parent->out == answer.out) ++row.hypotheses[kRemembered];
  }

  /// Nothing where the equations do not answer this operation.
  std::optional<bool> reference_has(const KnownQuestion& known, const Format& format) {
    const Answer answer = stable_->ask(known.question);
    if (answer.status == Answer::Status::skipped) return std::nullopt;
    return answer.status == Answer::Status::answered &&
           grade(known, answer, format, *stable_).which <= Class::rounding;
  }

  Implementation& subject_;
  const Plan& plan_;
  Verdict& verdict_;
  std::unique_ptr<Implementation> stable_;
  std::map<Op, bool> offers_;
};

}  // namespace

bool has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

bool is_offered(const Implementation& subject, const Verdict& verdict, Op op) {
  return subject.offered() ? subject.may_offer(op)
                           : !has(verdict.not_offered, std::string(operations::name(op)));
}

Row row_of(Op op, const std::string& hazard) {
  const operations::Operation& operation = operations::operation(op);
  const std::string name(operation.name);
  return {std::string(operation.part), name + "." + hazard, name, hazard, std::string(operation.page)};
}

bool wanted(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || std::any_of(list.begin(), list.end(), [&](const std::string& pattern) {
           return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
         });
}

std::vector<std::string> Plan::commands_of(const Question& question) const {
  std::vector<std::string> commands{command_of(question)};
  if (!command.empty()) commands.push_back(fmt::format("echo '{}' | {}", request_line(1, question), command));
  return commands;
}

void ask_known_answers(Implementation& subject, const Plan& plan, Verdict& verdict) {
  verdict.environment.bits = subject.format().bits;
  if (const auto failure = probe(subject, verdict.environment))
    verdict.note_failure({"the first questions", failure->reason, plan.commands_of(failure->question)});
  KnownAnswers(subject, plan, verdict).ask();
}

}  // namespace tps::properties::conform
