// The program: verbs over the libraries, exit codes, and nothing else.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "reference/process/descriptors.hpp"
#include "reference/process/interrupt.hpp"
#include "reference/process/missing_library.hpp"
#include "reference/run/run.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/output.hpp"
#include "reference/text/printable.hpp"
#include "reference/version.hpp"
#include "verify/cli/not_built.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verb_catalogue.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/when_called.hpp"

namespace tps::cli {
namespace {

bool has_dashes = false;
constexpr char kMark = '\x1f';

}  // namespace

bool command_line_has_dashes() {
  return has_dashes;
}

std::string as_typed(std::string word) {
  if (word.starts_with(kMark)) word.erase(0, 1);
  return word;
}

/// The words of the command line, those behind "--" marked where they look like a list.
std::vector<std::string> marked(int argc, char** argv) {
  std::vector<std::string> words(argv, argv + argc);
  const auto dashes = std::find(words.begin(), words.end(), "--");
  has_dashes = dashes != words.end();
  for (auto word = dashes; word != words.end(); ++word) {
    if (word->starts_with('[') || word->starts_with(kMark)) word->insert(0, 1, kMark);
  }
  return words;
}

}  // namespace tps::cli

namespace {

#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;  // names itself
#else
constexpr const char* kCompiler = "g++ " __VERSION__;
#endif

std::string version_text() {
  return fmt::format("tps {}\nsemantics {}\ncompiler {}\nprecisions {}", tps::version(),
                     tps::kSemanticsVersion, kCompiler, fmt::join(tps::scalar_names(), " "));
}

constexpr const char* kFooter =
    R"(Exit codes: 0 done, 1 a check found a violation, 2 usage, 3 bad input data, 4 another program
failed, 5 undecided, 6 the run stalled, 7 the output could not be written, 8 the run left the range
of its scalar, 70 an error of ours, 130 interrupted.
Example: tps run data/scenes/three-body.json)";

int report(const char* what, int exit_code) {
  tps::cli::say("tps: {}\n", tps::printable_lines(what));
  return exit_code;
}

/// What is wrong with the word that stands where a verb has to, and is none; empty where the mistake is
/// another.
std::string unknown_verb(const CLI::App& app) {
  const CLI::App* asked = &app;
  while (!asked->get_subcommands().empty()) asked = asked->get_subcommands().front();
  const std::vector<std::string> words = asked->remaining();
  if (asked->get_require_subcommand_min() == 0 || words.empty()) return {};
  const std::string& word = words.front();
  const std::string of = asked == &app ? "" : "tps " + asked->get_name() + ": ";
  if (word.starts_with('-'))
    return fmt::format("{}there is no option {}; tps {}--help lists what there is", of, word,
                       asked == &app ? "" : asked->get_name() + " ");
  std::vector<std::string> known;
  for (const CLI::App* verb : asked->get_subcommands([](const CLI::App*) { return true; }))
    known.push_back(verb->get_name());
  const std::string hint = tps::did_you_mean(word, known);
  return fmt::format("{}there is no {}{} {}", of, word, hint == "." ? "; there are" : hint + " There are",
                     fmt::join(known, ", "));
}

/// What CLI11 says: help and the like on standard output, errors of usage on the other.
int answer_usage(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out, err;  // what is wrong with a command line quotes it
  const bool done = app.exit(error, out, err) == 0;
  tps::cli::say("{}", tps::printable_lines(err.str()));
  if (!done) return tps::cli::kUsage;
  std::cout << out.str() << std::flush;
  return std::cout ? tps::cli::kDone
                   : report("standard output: cannot write the text", tps::cli::kOutputFailed);
}

int run(int argc, const char* const* argv) {
  int exit_code = tps::cli::kDone;
  CLI::App app("Reference implementation and oracle of the tethered particle system.", "tps");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  const std::vector<std::string>& missing = tps::cli::missing_verbs();
  app.footer(missing.empty() ? std::string(kFooter)
                             : fmt::format("./run build adds {}.\n{}", fmt::join(missing, ", "), kFooter));
  tps::cli::add_verbs(app, exit_code);
  tps::cli::refuse_empty_values(app);
  if (argc > 1 && std::count(missing.begin(), missing.end(), std::string_view(argv[1])) > 0) {
    return report(tps::cli::NotBuilt(std::string("tps ") + argv[1]).what(), tps::cli::kUsage);
  }
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::RequiredError& error) {
    const std::string unknown = unknown_verb(app);
    return unknown.empty() ? answer_usage(app, error) : report(unknown.c_str(), tps::cli::kUsage);
  } catch (const CLI::ParseError& error) {
    return answer_usage(app, error);
  } catch (const tps::cli::NotBuilt& error) {
    return report(error.what(), tps::cli::kUsage);
  } catch (const tps::interrupt::Interrupted&) {
    return report("interrupted", tps::cli::kInterrupted);
  } catch (const tps::InputError& error) {
    return report(error.what(), tps::cli::kBadInput);
  } catch (const tps::OutputError& error) {
    return report(error.what(), tps::cli::kOutputFailed);
  } catch (const tps::MissingLibrary& error) {
    return report(error.what(), tps::cli::kOtherProgram);
  } catch (const std::bad_alloc&) {
    return report("not enough memory for this input; give it in smaller parts", tps::cli::kBadInput);
  } catch (const std::exception& error) {
    return report((std::string("internal error, please report it: ") + error.what()).c_str(),
                  tps::cli::kInternal);
  }
}

}  // namespace

int main(int argc, char** argv) {
  tps::occupy_standard_descriptors();
  // A reader that goes away and a file that may not grow are errors of writing, reported like any other.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  tps::interrupt::install("tps");
  const std::vector<std::string> words = tps::cli::marked(argc, argv);
  std::vector<const char*> marked;
  for (const std::string& word : words) marked.push_back(word.c_str());
  const int exit_code = run(argc, marked.data());
  return tps::interrupt::requested() ? tps::cli::kInterrupted : exit_code;
}
