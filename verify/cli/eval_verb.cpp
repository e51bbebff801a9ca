// tps eval
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "reference/scene/nearest_name.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/eval/evaluate.hpp"

namespace tps::cli {
namespace {

std::string eval_footer() {
  std::string text = "Operations and their keys:\n";
  for (const eval::Operation& o : eval::operations()) {
    fmt::format_to(std::back_inserter(text), "  {:<19} eq. {:<10} {}\n", o.name, o.equation,
                   fmt::join(o.keys, " "));
  }
  return text +
         R"(Numbers are decimals, hexadecimal floats (0x1.8p+1) or inf (a mass). Answers are defined on stored
doubles: a decimal is read as the nearest double whatever the scalar, and rounded once more for float.
Every value is shown in decimal and, exactly, in hexadecimal; JSON has the hexadecimal spelling only.
Examples: tps eval block_time u_A=0,0 u_B=5,0 v_A=1,0 v_B=0,0 L=1
          echo '{"m_A":1,"m_B":"inf","v_A":[1,0],"v_B":[0,0]}' | tps eval load --in - --format json)";
}

const eval::Operation& operation_named(const std::string& name) {
  const eval::Operation* operation = eval::find_operation(name);
  if (operation == nullptr) {
    throw CLI::ValidationError(fmt::format("unknown operation {}; did you mean {}? There are {}", name,
                                           nearest_name(name, eval::operation_names()),
                                           fmt::join(eval::operation_names(), ", ")));
  }
  return *operation;
}

}  // namespace

void add_eval(CLI::App& app, int&) {
  struct Arguments {
    std::string op;
    std::vector<std::string> words;
    std::string in;
    std::string scalar = "double";
    std::string format = "text";
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("eval", "Evaluates one equation, with every intermediate value.");
  verb->add_option("op", a->op, "Operation, see below")->required();
  CLI::Option* words = verb->add_option("numbers", a->words, "key=value …, vectors as u_A=0,0 or u_A=0,0,0");
  verb->add_option("--in", a->in, "JSON object with the keys, - for standard input")->excludes(words);
  verb->add_option("--scalar", a->scalar)->check(CLI::IsMember(eval::scalars()))->capture_default_str();
  verb->add_option("--format", a->format)->check(CLI::IsMember({"text", "json"}))->capture_default_str();
  verb->footer(eval_footer());
  verb->callback([a] {
    const eval::Operation& operation = operation_named(a->op);
    const eval::Input input =
        a->in.empty() ? eval::read_words(operation, a->words) : eval::read_json(operation, a->in);
    const eval::Report report = eval::evaluate(operation, input, a->scalar);
    write_result("-", a->format == "json" ? eval::report_json(operation, a->scalar, report)
                                          : eval::report_text(operation, a->scalar, report));
  });
}

}  // namespace tps::cli
