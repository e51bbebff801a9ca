// tps eval
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "reference/run/run.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/certified/why.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/eval/evaluate.hpp"
#include "verify/eval/no_answer.hpp"
#include "verify/protocol/answer.hpp"
#include "verify/protocol/compound.hpp"

namespace tps::cli {
namespace {

std::string eval_footer() {
  std::string text = "Operations and their keys:\n";
  for (const eval::Operation& o : eval::operations()) {
    fmt::format_to(std::back_inserter(text), "  {:<19} {:<15} {}\n", o.name, eval::rule_name(o),
                   fmt::join(o.keys, " "));
  }
  text += "Without --scalar, by --in (order also by words such as first.kind=block first.u_A=0,0):\n";
  for (const protocol::Compound& c : protocol::compounds()) {
    fmt::format_to(std::back_inserter(text), "  {:<19} {}, {}: {}\n", c.name, c.precision, c.what, c.input);
  }
  return text +
         R"(Numbers are decimals, hexadecimal floats (0x1.8p+1) or inf (a mass). Answers are defined on stored
doubles: a decimal is read as the nearest double whatever the scalar, and rounded once more for float.
Every value is shown in decimal and, exactly, in hexadecimal; JSON has the hexadecimal spelling only.
Examples: tps eval block_time u_A=0,0 u_B=5,0 v_A=1,0 v_B=0,0 L=1
          echo '{"m_A":1,"m_B":"inf","v_A":[1,0],"v_B":[0,0]}' | tps eval load --in - --format json)";
}

constexpr const char* kWhyAnswers = "--why is for block_time, tether_time and order, in double";

struct EvalArguments {
  std::string op;
  std::vector<std::string> words;
  std::string in;
  std::string scalar = "double";
  std::string format = "text";
  bool why = false;
};

const eval::Operation& operation_named(const std::string& name) {
  const eval::Operation* operation = eval::find_operation(name);
  if (operation == nullptr) {
    std::vector<std::string> names = eval::operation_names();
    for (const protocol::Compound& c : protocol::compounds()) names.emplace_back(c.name);
    throw CLI::ValidationError(fmt::format("unknown operation {}{} There are {}", name,
                                           did_you_mean(name, names), fmt::join(names, ", ")));
  }
  return *operation;
}

void print_report(const EvalArguments& a, std::string_view what, std::string_view precision,
                  const eval::Report& report) {
  write_result("-", a.format == "json"
                        ? eval::report_json(a.op, precision, report)
                        : eval::report_text(fmt::format("{}: {}; {}", a.op, what, precision), report));
}

/// In JSON as the protocol has it.
void print_json(const EvalArguments& a, const protocol::Compound& operation, const std::string& out) {
  write_result(
      "-", fmt::format("{{\"op\":\"{}\",\"scalar\":\"{}\",\"out\":{}}}\n", a.op, operation.precision, out));
}

/// order, group, next_event.
void eval_compound(const EvalArguments& a, const protocol::Compound& operation) {
  if (a.scalar != "double") {
    throw CLI::ValidationError(
        fmt::format("{} takes no --scalar: its values are {}", a.op, operation.precision));
  }
  const bool is_order = a.op == "order";
  if (a.why && !is_order) throw CLI::ValidationError(kWhyAnswers);
  if (a.in.empty() && !is_order) {
    throw CLI::ValidationError(fmt::format("{} takes its input by --in FILE, - for standard input", a.op));
  }
  if (is_order && (a.why || a.in.empty())) {
    const protocol::OrderInput input =
        a.in.empty() ? protocol::read_order_words(a.words) : protocol::read_order_file(a.in);
    if (a.why) {
      return print_report(a, operation.what, operation.precision,
                          certified::why_order(input.first, input.second));
    }
    const auto order = protocol::answer_order(input);
    return a.format == "json"
               ? print_json(a, operation, json_text(order))
               : print_report(a, operation.what, operation.precision, protocol::report_of(order));
  }
  if (a.format == "json") return print_json(a, operation, protocol::answer_file(operation, a.in));
  print_report(a, operation.what, operation.precision, protocol::report_file(operation, a.in));
}

eval::Report evaluated(const EvalArguments& a, const eval::Operation& operation, const eval::Input& input) {
  try {
    return eval::evaluate(operation, input, a.scalar);
  } catch (const eval::NoAnswer& why) {
    throw why.in(a.in.empty() ? a.op : a.in, 0, "");
  }
}

void eval_equation(const EvalArguments& a, const eval::Operation& operation) {
  const eval::Input input =
      a.in.empty() ? eval::read_words(operation, a.words) : eval::read_json(operation, a.in);
  if (a.why) {
    const bool block = operation.op == eval::Op::block_time;
    if ((!block && operation.op != eval::Op::tether_time) || a.scalar != "double")
      throw CLI::ValidationError(kWhyAnswers);
    const certified::TimingInput timing{block ? exact::Kind::block : exact::Kind::tether, input};
    return print_report(a, operation.what, "certified, beside double", certified::why_time(timing));
  }
  const eval::Report report = evaluated(a, operation, input);
  write_result("-", a.format == "json" ? eval::report_json(operation, a.scalar, report)
                                       : eval::report_text(operation, a.scalar, report));
}

}  // namespace

void add_eval(CLI::App& app, int&) {
  const auto a = std::make_shared<EvalArguments>();
  CLI::App* verb = app.add_subcommand("eval", "Evaluates one equation, with every intermediate value.");
  verb->add_option("op", a->op, "Operation, see below")->required();
  CLI::Option* words = verb->add_option("numbers", a->words, "key=value …, vectors as u_A=0,0 or u_A=0,0,0");
  verb->add_option("--in", a->in, "JSON object with the keys, - for standard input")->excludes(words);
  verb->add_option("--scalar", a->scalar)->check(CLI::IsMember(scalar_names()))->capture_default_str();
  verb->add_option("--format", a->format)->check(CLI::IsMember({"text", "json"}))->capture_default_str();
  verb->add_flag(
      "--why", a->why,
      "block_time, tether_time, order: the certified answer beside the computed one, and what settled it");
  verb->footer(eval_footer());
  verb->callback([a] {
    NamedFiles().reads("--in", a->in).require_distinct();
    const protocol::Compound* compound = protocol::find_compound(a->op);
    if (compound != nullptr) return eval_compound(*a, *compound);
    eval_equation(*a, operation_named(a->op));
  });
}

}  // namespace tps::cli
