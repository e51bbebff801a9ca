// tps vectors
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "reference/text/output.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/when_called.hpp"
#include "verify/vectors/generate.hpp"
#include "verify/vectors/judge_files.hpp"

namespace tps::cli {
namespace {

using vectors::Stratum;

struct Selection {
  std::vector<std::string> ops;
  std::vector<std::string> names;

  bool has(const Stratum& stratum) const {
    const auto wanted = [](const std::vector<std::string>& list, const std::string& name) {
      return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
    };
    return wanted(ops, std::string(operations::name(stratum.op))) && wanted(names, stratum.name);
  }
};

void add_selection(CLI::App& verb, Selection& selection) {
  std::set<std::string> ops, names;
  for (const Stratum& stratum : vectors::strata()) {
    ops.emplace(operations::name(stratum.op));
    names.insert(stratum.name);
  }
  verb.add_option("--op", selection.ops, "Only these operations")->check(CLI::IsMember(ops));
  verb.add_option("--stratum", selection.names, "Only these strata")->check(CLI::IsMember(names));
}

/// Each word may be right and the two together none.
void require_any(const Selection& selection) {
  const std::vector<Stratum>& all = vectors::strata();
  if (std::any_of(all.begin(), all.end(), [&](const Stratum& stratum) { return selection.has(stratum); }))
    return;
  std::vector<std::string> names;
  for (const Stratum& stratum : all) {
    if (Selection{selection.ops, {}}.has(stratum)) names.push_back(stratum.name);
  }
  throw CLI::ValidationError("--stratum",
                             fmt::format("{} has no {}; it has {}", fmt::join(selection.ops, ", "),
                                         fmt::join(selection.names, ", "), fmt::join(names, ", ")));
}

void list_strata(const Selection& selection) {
  require_any(selection);
  Output out("-");
  for (const Stratum& s : vectors::strata()) {
    if (selection.has(s))
      out.write(fmt::format("{:<19} {:<14} {:>4}  {}\n", operations::name(s.op), s.name, s.committed, s.why));
  }
  out.close();
}

struct GenerateArguments {
  Selection selection;
  int level = 2;
  std::uint64_t count = 1000;
  std::uint64_t seed = vectors::kCommittedSeed;
  std::string output = "-";
};

std::string file_of(const GenerateArguments& a, const Stratum& stratum) {
  return a.output + "/" + stratum.file_name();
}

void generate(const GenerateArguments& a) {
  require_any(a.selection);
  std::unique_ptr<Output> out;
  if (a.output == "-") {
    out = std::make_unique<Output>("-");
  } else {
    std::error_code error;
    std::filesystem::create_directories(a.output, error);
    if (error) throw OutputError(fmt::format("cannot create the folder {}: {}", a.output, error.message()));
  }
  NamedFiles files;
  for (const Stratum& stratum : vectors::strata()) {
    if (a.selection.has(stratum) && a.output != "-") files.writes("-o", file_of(a, stratum));
  }
  files.require_distinct();
  for (const Stratum& stratum : vectors::strata()) {
    if (!a.selection.has(stratum)) continue;
    if (a.output != "-") out = std::make_unique<Output>(file_of(a, stratum));
    write_stratum(stratum, a.seed, extent_of(stratum, a.level, a.count),
                  [&](std::string_view line) { out->write(line); });
    if (a.output != "-") out->close();
  }
  if (a.output == "-") out->close();
}

void add_generate(CLI::App& verb) {
  const auto a = std::make_shared<GenerateArguments>();
  CLI::App* generating = verb.add_subcommand("generate", "Writes known-answer files.");
  add_selection(*generating, a->selection);
  generating
      ->add_option("--level", a->level,
                   "1: the first cases of each; 2: what is committed; 3: those behind it")
      ->check(CLI::Range(1, 3))
      ->capture_default_str();
  generating->add_option("--count", a->count, "Cases a stratum at level 3")
      ->check(integer_from(0, "a number of cases"))
      ->capture_default_str();
  generating->add_option("--seed", a->seed, "Another seed has other cases")
      ->check(integer_from(0, "a seed"))
      ->capture_default_str();
  generating->add_option("-o,--output", a->output, "A folder, - for standard output")->capture_default_str();
  generating->footer("Example: tps vectors generate -o data/vectors");
  generating->callback([a] { generate(*a); });
}

void add_verify(CLI::App& verb, int& exit_code) {
  struct Arguments {
    std::vector<std::string> files;
    std::string answers;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* verifying =
      verb.add_subcommand("verify", "Proves known answers again, or judges answers by them.");
  verifying->add_option("files", a->files, "Known-answer files, - for standard input")->required();
  verifying->add_option("--answers", a->answers, "Replies of an implementation, - for standard input");
  verifying->footer(
      "Exit code 1 if a case or an answer is wrong, or a question of an operation that is offered is "
      "refused;\n"
      "5 if nothing was judged.\n"
      "Example: tps vectors requests V | ./my-program | tps vectors verify V --answers -");
  verifying->callback([a, &exit_code] {
    exit_code = a->answers.empty() ? verify_cases(a->files) : verify_answers(a->files, a->answers);
  });
}

void add_vectors_options(CLI::App* verb, int& exit_code) {
  verb->require_subcommand(1);
  verb->footer("Example: tps vectors verify data/vectors/order.twins.jsonl");
  add_generate(*verb);
  add_verify(*verb, exit_code);
  const auto selection = std::make_shared<Selection>();
  CLI::App* listing =
      verb->add_subcommand("list", "Lists the strata: operation, name, committed cases, aim.");
  add_selection(*listing, *selection);
  listing->footer("Example: tps vectors list --op block_time");
  listing->callback([selection] { list_strata(*selection); });
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* requesting = verb->add_subcommand("requests", "Writes the cases as requests of the protocol.");
  requesting->add_option("files", *files, "Known-answer files, - for standard input")->required();
  requesting->footer("Example: tps vectors requests data/vectors/order.twins.jsonl | ./my-program");
  requesting->callback([files] { write_requests(*files); });
}

}  // namespace

void add_vectors(CLI::App& app, int& exit_code) {
  CLI::App* verb =
      app.add_subcommand("vectors", "Known answers that prove themselves: writes, lists, judges.");
  make_when_called(verb, [&exit_code](CLI::App* called) { add_vectors_options(called, exit_code); });
}

}  // namespace tps::cli
