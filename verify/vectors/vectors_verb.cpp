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

#include "reference/text/file_kind.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/line_source.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/output.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "reference/text/text_file.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/protocol/answer.hpp"
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
    refuse_other_kinds_of_file(file, "a file of known answers", {FileKind::known_answers});
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

/// Replies by the number of the case in the files as given (seq), or by its id; and the operations that the
/// answer to hello names, if one is there.
struct Replies {
  std::unordered_map<std::string, Json> by_case;
  std::set<std::string> offered;

  const Json* find(const Json& known, std::uint64_t seq) const {
    auto reply = by_case.find(json_text(known.at("id")));
    if (reply == by_case.end()) reply = by_case.find(std::to_string(seq));
    return reply == by_case.end() ? nullptr : &reply->second;
  }
};

void require_distinct(const std::vector<std::string>& files, const std::string& answers = "") {
  NamedFiles named;
  for (const std::string& file : files) named.reads("files", file);
  named.reads("--answers", answers).require_distinct();
}

Replies read_replies(const std::string& path) {
  refuse_other_kinds_of_file(path, "a file of replies", {FileKind::replies});
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
    if (reply.is_object() && reply.contains("name") && !named) {  // the answer to hello
      for (const Json& op : reply.value("ops", Json::array())) {
        if (op.is_string()) replies.offered.insert(op.get<std::string>());
      }
      continue;
    }
    if (!named) {
      throw InputError(
          {{path, number, "", R"(is not a reply; allowed: {"id":…,"out":{…}} or {"seq":n,"out":{…}})"}});
    }
    const std::string key = json_text(reply.contains("id") ? reply["id"] : reply["seq"]);
    replies.by_case[key] = std::move(reply);
  }
  return replies;
}

/// Counts, reports the first problems, and remembers whether there were any.
class Findings {
 public:
  void problem(const vectors::Place& place, const std::string& text) {
    ++problems_;
    report(place, text);
  }
  void refusal(const vectors::Place& place, const std::string& text) {
    ++refused_;
    report(place, text);
  }
  void judged() { ++judged_; }
  void skipped() { ++skipped_; }

  int conclude(const std::string& what) const {
    Output out("-");
    const auto counted = [](std::uint64_t count, const char* words) {
      return count > 0 ? fmt::format(", {} {}", count, words) : "";
    };
    out.write(fmt::format("{} {}, {} wrong{}{}\n", judged_, what, problems_,
                          counted(refused_, "refused or without an answer"),
                          counted(skipped_, "of operations that are not offered")));
    out.close();
    if (problems_ > 0 || refused_ > 0) return kViolation;
    return judged_ == 0 ? kUndecided : kDone;
  }

 private:
  void report(const vectors::Place& place, const std::string& text) {
    const std::uint64_t reported = problems_ + refused_;
    if (reported <= shown)
      say("{}:{}: {}\n", printable(place.file), place.line, printable(text, kLongestProblem));
    if (reported == shown + 1) say("… further problems are counted only\n");
  }

  static constexpr std::uint64_t shown = 20;
  static constexpr std::size_t kLongestProblem = 1000;
  std::uint64_t judged_ = 0, problems_ = 0, refused_ = 0, skipped_ = 0;
};

/// What a case is called in messages.
std::string name_of(const Json& known) {
  return known.is_object() && known.contains("id") && known.at("id").is_string()
             ? known.at("id").get<std::string>()
             : "case";
}

/// What is wrong where the header names an operation that is none: nobody can be asked, so nobody is excused.
std::optional<std::string> unknown_operation(const std::string& op) {
  const std::vector<std::string>& known = protocol::operation_names();
  if (std::find(known.begin(), known.end(), op) != known.end()) return std::nullopt;
  return fmt::format("the header names operation \"{}\", which there is not; did you mean {}?",
                     printable(op, kShownOfText), nearest_name(op, known));
}

int verify_cases(const std::vector<std::string>& files) {
  require_distinct(files);
  Findings findings;
  read_all(files, {[&](const std::string& op, const Json& known, const vectors::Place& place) {
                     findings.judged();
                     const auto wrong = vectors::wrong_in_case(op, known);
                     if (wrong) findings.problem(place, name_of(known) + ": " + *wrong);
                   },
                   [&](const std::string& problem, const vectors::Place& place) {
                     findings.problem(place, problem);
                   }});
  return findings.conclude("cases proven again");
}

/// The first line of what somebody else wrote.
std::string shortened(const Json& reply) {
  constexpr std::size_t longest = 200;
  return printable(json_text(reply), longest);
}

struct AskedCase {
  std::string op, id;
  vectors::Place place;
};

/// A known answer asks a question of its operation, so whoever offers the operation has to answer it: an
/// error, silence or a skip is then a refusal. An operation is offered by the answer to hello or by any
/// answer.
int verify_answers(const std::vector<std::string>& files, const std::string& answers) {
  require_distinct(files, answers);
  Replies replies = read_replies(answers);
  const bool said_hello = !replies.offered.empty();
  Findings findings;
  std::uint64_t seq = 0;
  std::vector<AskedCase> skips;
  read_all(files, {[&](const std::string& op, const Json& known, const vectors::Place& place) {
                     ++seq;
                     const std::string id = name_of(known);
                     if (const auto unknown = unknown_operation(op))
                       return findings.problem(place, id + ": " + *unknown);
                     const Json* reply = known.contains("id") ? replies.find(known, seq) : nullptr;
                     if (reply == nullptr) return findings.refusal(place, id + ": has no reply");
                     if (reply->contains("out")) {
                       // What is not proven judges nobody.
                       if (const auto unproven = vectors::wrong_in_case(op, known))
                         return findings.problem(place, id + ": is no known answer: " + *unproven);
                       if (!said_hello) replies.offered.insert(op);
                       findings.judged();
                       const auto wrong = vectors::wrong_in_answer(op, known, reply->at("out"));
                       if (wrong) findings.problem(place, id + ": " + *wrong);
                     } else if (reply->contains("skip")) {
                       skips.push_back({op, id, place});
                     } else {
                       findings.refusal(place, fmt::format("{}: is refused: {}", id, shortened(*reply)));
                     }
                   },
                   [&](const std::string& problem, const vectors::Place& place) {
                     findings.problem(place, problem);
                   }});
  for (const AskedCase& skipped : skips) {
    if (!replies.offered.contains(skipped.op)) {
      findings.skipped();
    } else {
      findings.refusal(skipped.place,
                       fmt::format("{}: is skipped, though {} is offered", skipped.id, skipped.op));
    }
  }
  return findings.conclude("answers judged");
}

void write_requests(const std::vector<std::string>& files) {
  require_distinct(files);
  Output out("-");
  std::uint64_t seq = 0;
  read_all(files,
           {[&](const std::string& op, const Json& known, const vectors::Place& place) {
              if (const auto unknown = unknown_operation(op))
                throw InputError({{place.file, place.line, "", *unknown}});
              if (!known.is_object() || !known.contains("in")) {
                throw InputError({{place.file, place.line, "", "the case has no \"in\", its question"}});
              }
              out.write(json_text(Json{{"seq", ++seq}, {"op", op}, {"in", known.at("in")}}) + "\n");
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
      "Exit code 1 if a case or an answer is wrong, or a question of an operation that is offered is "
      "refused;\n"
      "5 if nothing was judged.\n"
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
