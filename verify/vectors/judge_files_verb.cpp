// tps vectors verify, tps vectors requests
#include "verify/vectors/judge_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "reference/text/file_kind.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/output.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/protocol/answer.hpp"
#include "verify/vectors/check_answers.hpp"
#include "verify/vectors/read_vectors.hpp"
#include "verify/vectors/replies.hpp"

namespace tps::cli {
namespace {

using vectors::Json;

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

void require_distinct(const std::vector<std::string>& files, const std::string& answers = "") {
  NamedFiles named;
  for (const std::string& file : files) named.reads("files", file);
  named.reads("--answers", answers).require_distinct();
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

/// Cases that share an id may be proven together, but a reply that names it answers nobody knows which.
class Ids {
 public:
  /// What is wrong with a case that a reply names by its id.
  std::optional<std::string> wrong_in(const Json& known, const vectors::Place& place) {
    const auto [first, is_new] = seen_.try_emplace(name_of(known), place);
    if (is_new) return std::nullopt;
    return fmt::format("the id stands twice, first at {}:{}", printable(first->second.file),
                       first->second.line);
  }

 private:
  std::unordered_map<std::string, vectors::Place> seen_;
};

/// The operation that a header names. Where there is none of that name nobody can be asked, so nobody is
/// excused: `wrong` says so.
struct NamedOperation {
  explicit NamedOperation(const std::string& name) : operation(operations::find(name)) {
    if (operation != nullptr && operation->is_certified) return;
    wrong =
        fmt::format("the header names operation \"{}\", which {}", printable(name, kShownOfText),
                    operation != nullptr ? "has no known answers"
                                         : "there is not" + did_you_mean(name, protocol::operation_names()));
  }

  const operations::Operation* operation;
  std::optional<std::string> wrong;
};

/// The first line of what somebody else wrote.
std::string shortened(const Json& reply) {
  constexpr std::size_t longest = 200;
  return printable(json_text(reply), longest);
}

struct AskedCase {
  std::string op, id;
  vectors::Place place;
};

}  // namespace

int verify_cases(const std::vector<std::string>& files) {
  require_distinct(files);
  Findings findings;
  read_all(
      files,
      {[&](const std::string& op, const Json& known, const vectors::Place& place) {
         findings.judged();
         const NamedOperation named(op);
         const auto wrong = named.wrong ? named.wrong : vectors::wrong_in_case(named.operation->op, known);
         if (wrong) findings.problem(place, name_of(known) + ": " + *wrong);
       },
       [&](const std::string& problem, const vectors::Place& place) { findings.problem(place, problem); }});
  return findings.conclude("cases proven again");
}

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
  Ids ids;
  read_all(
      files,
      {[&](const std::string& op, const Json& known, const vectors::Place& place) {
         ++seq;
         const std::string id = name_of(known);
         const NamedOperation named(op);
         if (named.wrong) return findings.problem(place, id + ": " + *named.wrong);
         const Json* reply = known.contains("id") ? replies.find(known, seq) : nullptr;
         if (reply != nullptr && replies.names(known)) {
           if (const auto twice = ids.wrong_in(known, place))
             return findings.problem(place, id + ": " + *twice);
         }
         if (reply == nullptr) return findings.refusal(place, id + ": has no reply");
         if (reply->contains("out")) {
           // What is not proven judges nobody.
           if (const auto unproven = vectors::wrong_in_case(named.operation->op, known))
             return findings.problem(place, id + ": is no known answer: " + *unproven);
           if (!said_hello) replies.offered.insert(op);
           findings.judged();
           const auto wrong = vectors::wrong_in_answer(named.operation->op, known, reply->at("out"));
           if (wrong) findings.problem(place, id + ": " + *wrong);
         } else if (reply->contains("skip")) {
           skips.push_back({op, id, place});
         } else {
           findings.refusal(place, fmt::format("{}: is refused: {}", id, shortened(*reply)));
         }
       },
       [&](const std::string& problem, const vectors::Place& place) { findings.problem(place, problem); }});
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
              if (const NamedOperation named(op); named.wrong)
                throw InputError({{place.file, place.line, "", *named.wrong}});
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

}  // namespace tps::cli
