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
#include "verify/operations/evaluate.hpp"
#include "verify/operations/no_answer.hpp"
#include "verify/operations/request_file.hpp"
#include "verify/protocol/answer.hpp"
#include "verify/protocol/report_of.hpp"

namespace tps::cli {
namespace {

using operations::Op;
using operations::Operation;

std::string eval_footer() {
  std::string text = "Operations and their keys:\n";
  std::string others =
      "Without --scalar, by --in (order also by words such as first.kind=block first.u_A=0,0):\n";
  for (const Operation& o : operations::catalogue()) {
    if (operations::is_of_numbers(o)) {
      fmt::format_to(std::back_inserter(text), "  {:<19} {:<15} {}\n", o.name, operations::rule_name(o),
                     fmt::join(o.keys, " "));
    } else {
      fmt::format_to(std::back_inserter(others), "  {:<19} {}, {}: {}\n", o.name, o.precision, o.what,
                     o.input);
    }
  }
  return text + others +
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

const Operation& operation_named(const std::string& name) {
  const Operation* operation = operations::find(name);
  if (operation == nullptr) {
    std::vector<std::string> names;
    for (const Operation& each : operations::catalogue()) names.emplace_back(each.name);
    throw CLI::ValidationError(fmt::format("unknown operation {}{} There are {}", name,
                                           did_you_mean(name, names), fmt::join(names, ", ")));
  }
  return *operation;
}

void print(const EvalArguments& a, std::string_view heading, std::string_view precision,
           const operations::Report& report) {
  write_result("-", a.format == "json" ? operations::report_json(a.op, precision, report)
                                       : operations::report_text(heading, report));
}

void print(const EvalArguments& a, const Operation& operation, std::string_view precision,
           const operations::Report& report) {
  print(a, fmt::format("{}: {}; {}", operation.name, operation.what, precision), precision, report);
}

/// In JSON as the protocol has it.
void print_json(const Operation& operation, const std::string& out) {
  write_result("-", fmt::format("{{\"op\":\"{}\",\"scalar\":\"{}\",\"out\":{}}}\n", operation.name,
                                operation.precision, out));
}

void eval_order(const EvalArguments& a, const Operation& operation) {
  operations::OrderInput input;
  if (a.in.empty()) {
    input = operations::read_order_words(a.words);
  } else {
    const operations::RequestFile file(operation, a.in);
    input = operations::read_order(file.in(), file.place());
  }
  if (a.why) return print(a, operation, operation.precision, certified::why_order(input.first, input.second));
  const auto order = protocol::answer_order(input);
  a.format == "json" ? print_json(operation, json_text(order))
                     : print(a, operation, operation.precision, protocol::report_of(order));
}

/// order, group, next_event, simulate.
void eval_compound(const EvalArguments& a, const Operation& operation) {
  if (a.scalar != "double") {
    throw CLI::ValidationError(
        fmt::format("{} takes no --scalar: its values are {}", a.op, operation.precision));
  }
  if (operation.op == Op::order) return eval_order(a, operation);
  if (a.why) throw CLI::ValidationError(kWhyAnswers);
  if (a.in.empty())
    throw CLI::ValidationError(fmt::format("{} takes its input by --in FILE, - for standard input", a.op));
  const operations::RequestFile file(operation, a.in);
  const auto out = [&] { return protocol::answer_text(operation.op, file.in(), file.place()); };
  if (a.format == "json") return print_json(operation, out());
  print(a, operation, operation.precision,
        protocol::report_of(operation.op == Op::simulate
                                ? parse_plain_json(out(), "trace")
                                : protocol::answer(operation.op, file.in(), file.place())));
}

operations::Report evaluated(const EvalArguments& a, const Operation& operation,
                             const operations::Input& input) {
  try {
    return operations::evaluate(operation, input, a.scalar);
  } catch (const operations::NoAnswer& why) {
    throw why.in(a.in.empty() ? a.op : a.in, 0, "");
  }
}

operations::Input read_input(const EvalArguments& a, const Operation& operation) {
  if (a.in.empty()) return operations::read_words(operation, a.words);
  const operations::RequestFile file(operation, a.in);
  return operations::read_value(operation, file.in(), file.place());
}

void eval_equation(const EvalArguments& a, const Operation& operation) {
  const operations::Input input = read_input(a, operation);
  if (a.why) {
    const auto kind = operations::timing_kind(operation.op);
    if (!kind || kind == TimingKind::plane || a.scalar != "double") throw CLI::ValidationError(kWhyAnswers);
    return print(a, operation, "certified, beside double", certified::why_time({*kind, input}));
  }
  print(a,
        fmt::format("{}, {}: {}; in {}", operation.name, operations::rule_name(operation), operation.what,
                    a.scalar),
        a.scalar, evaluated(a, operation, input));
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
    const Operation& operation = operation_named(a->op);
    operations::is_of_numbers(operation) ? eval_equation(*a, operation) : eval_compound(*a, operation);
  });
}

}  // namespace tps::cli
