// tps vectors
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_map>

#include "reference/scene/input_error.hpp"
#include "reference/scene/text_file.hpp"
#include "reference/text/line_source.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "reference/trace/output.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/vectors/check_answers.hpp"
#include "verify/vectors/generate.hpp"
#include "verify/vectors/read_vectors.hpp"

namespace tps::cli {
namespace {

using vectors::Json;
using vectors::Stratum;

struct Selection {
  std::vector<std::string> ops;
  std::vector<std::string> names;

  bool has(const Stratum& stratum) const {
    const auto wanted = [](const std::vector<std::string>& list, const std::string& name) {
      return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
    };
    return wanted(ops, stratum.op) && wanted(names, stratum.name);
  }
};

void add_selection(CLI::App& verb, Selection& selection) {
  std::set<std::string> ops, names;
  for (const Stratum& stratum : vectors::strata()) {
    ops.insert(stratum.op);
    names.insert(stratum.name);
  }
  verb.add_option("--op", selection.ops, "Only these operations")->check(CLI::IsMember(ops));
  verb.add_option("--stratum", selection.names, "Only these strata")->check(CLI::IsMember(names));
}

void list_strata(const Selection& selection) {
  Output out("-");
  for (const Stratum& s : vectors::strata()) {
    if (selection.has(s))
      out.write(fmt::format("{:<19} {:<14} {:>4}  {}\n", s.op, s.name, s.committed, s.why));
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

/// Reads every file, "-" being standard input.
void read_all(const std::vector<std::string>& files, const vectors::VectorsVisitor& visitor) {
  for (const std::string& file : files) {
    if (file == "-") {
      vectors::read_vectors(std::cin, "standard input", visitor);
      continue;
    }
    std::ifstream in(file, std::ios::binary);
    std::error_code unknown;
    if (!in || std::filesystem::is_directory(file, unknown)) {
      throw InputError(
          {{file, 0, "",
            "cannot be read; name files such as data/vectors/*.jsonl, or - for standard input"}});
    }
    vectors::read_vectors(in, file, visitor);
  }
}

constexpr std::size_t kLongestReply = std::size_t{1} << 20U;

/// Replies by the number of the case in the files as given (seq), or by its id.
using Replies = std::unordered_map<std::string, Json>;

void require_distinct(const std::vector<std::string>& files, const std::string& answers = "") {
  NamedFiles named;
  for (const std::string& file : files) named.reads("files", file);
  named.reads("--answers", answers).require_distinct();
}

Replies read_replies(const std::string& path) {
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& in = path == "-" ? std::cin : file;
  std::error_code unknown;
  if (!in || (path != "-" && std::filesystem::is_directory(path, unknown))) {
    throw InputError({{path, 0, "", "cannot be read; --answers takes one reply a line"}});
  }
  Replies replies;
  std::string line;
  LineRead read;
  for (std::size_t number = 1; read_line(in, line, kLongestReply, read); ++number) {
    if (read.too_long) {
      throw InputError(
          {{path, number, "", fmt::format("is longer than {} bytes; no reply is", kLongestReply)}});
    }
    Json reply = parse_plain_json(line, display_name(path), {}, number);
    const bool named = reply.is_object() && (reply.contains("id") || reply.contains("seq"));
    if (reply.is_object() && reply.contains("name") && !named) continue;  // the answer to hello
    if (!named) {
      throw InputError(
          {{path, number, "", R"(is not a reply; allowed: {"id":…,"out":{…}} or {"seq":n,"out":{…}})"}});
    }
    const std::string key = (reply.contains("id") ? reply["id"] : reply["seq"]).dump();
    replies[key] = std::move(reply);
  }
  return replies;
}

/// Counts, reports the first problems, and remembers whether there were any.
class Findings {
 public:
  void problem(const vectors::Place& place, const std::string& text) {
    ++problems_;
    if (problems_ <= shown)
      say("{}:{}: {}\n", printable(place.file), place.line, printable(text, kLongestProblem));
    if (problems_ == shown + 1) say("… further problems are counted only\n");
  }
  void judged() { ++judged_; }
  void skipped() { ++skipped_; }

  int conclude(const std::string& what) const {
    Output out("-");
    out.write(fmt::format("{} {}, {} wrong{}\n", judged_, what, problems_,
                          skipped_ > 0 ? fmt::format(", {} without an answer", skipped_) : ""));
    out.close();
    if (problems_ > 0) return kViolation;
    return judged_ == 0 ? kUndecided : kDone;
  }

 private:
  static constexpr std::uint64_t shown = 20;
  static constexpr std::size_t kLongestProblem = 1000;
  std::uint64_t judged_ = 0, problems_ = 0, skipped_ = 0;
};

int verify_cases(const std::vector<std::string>& files) {
  require_distinct(files);
  Findings findings;
  read_all(files, {[&](const std::string& op, const Json& known, const vectors::Place& place) {
                     findings.judged();
                     const auto wrong = vectors::wrong_in_case(op, known);
                     if (wrong) findings.problem(place, known.value("id", "case") + ": " + *wrong);
                   },
                   [&](const std::string& problem, const vectors::Place& place) {
                     findings.problem(place, problem);
                   }});
  return findings.conclude("cases proven again");
}

int verify_answers(const std::vector<std::string>& files, const std::string& answers) {
  require_distinct(files, answers);
  const Replies replies = read_replies(answers);
  Findings findings;
  std::uint64_t seq = 0;
  read_all(files, {[&](const std::string& op, const Json& known, const vectors::Place& place) {
                     ++seq;
                     auto reply = replies.find(known.at("id").dump());
                     if (reply == replies.end()) reply = replies.find(std::to_string(seq));
                     if (reply == replies.end() || !reply->second.contains("out")) return findings.skipped();
                     findings.judged();
                     const auto wrong = vectors::wrong_in_answer(op, known, reply->second.at("out"));
                     if (wrong) findings.problem(place, known.at("id").get<std::string>() + ": " + *wrong);
                   },
                   [&](const std::string& problem, const vectors::Place& place) {
                     findings.problem(place, problem);
                   }});
  return findings.conclude("answers judged");
}

void write_requests(const std::vector<std::string>& files) {
  require_distinct(files);
  Output out("-");
  std::uint64_t seq = 0;
  read_all(files, {[&](const std::string& op, const Json& known, const vectors::Place&) {
                     out.write(Json{{"seq", ++seq}, {"op", op}, {"in", known.at("in")}}.dump() + "\n");
                   },
                   [](const std::string& problem, const vectors::Place& place) {
                     throw InputError({{place.file, place.line, "", problem}});
                   }});
  out.close();
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
      "Exit code 1 if a case or an answer is wrong, 5 if there was none.\n"
      "Example: tps vectors requests V | ./my-program | tps vectors verify V --answers -");
  verifying->callback([a, &exit_code] {
    exit_code = a->answers.empty() ? verify_cases(a->files) : verify_answers(a->files, a->answers);
  });
}

}  // namespace

void add_vectors(CLI::App& app, int& exit_code) {
  CLI::App* verb =
      app.add_subcommand("vectors", "Known answers that prove themselves: writes, lists, judges.");
  verb->require_subcommand(1);
  verb->footer("Example: tps vectors verify data/vectors/order.twins.jsonl");
  add_generate(*verb);
  add_verify(*verb, exit_code);
  const auto selection = std::make_shared<Selection>();
  CLI::App* listing =
      verb->add_subcommand("list", "Lists the strata: operation, name, committed cases, aim.");
  add_selection(*listing, *selection);
  listing->callback([selection] { list_strata(*selection); });
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* requesting = verb->add_subcommand("requests", "Writes the cases as requests of the protocol.");
  requesting->add_option("files", *files, "Known-answer files, - for standard input")->required();
  requesting->callback([files] { write_requests(*files); });
}

}  // namespace tps::cli
