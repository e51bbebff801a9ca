// The program: verbs over the libraries, exit codes, and nothing else.
#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "reference/run/run.hpp"
#include "reference/scene/input_error.hpp"
#include "reference/trace/output.hpp"
#include "reference/version.hpp"
#include "verify/cli/verbs.hpp"

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
  fmt::print(stderr, "tps: {}\n", what);
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that goes away is an error of writing, reported like any other.
  std::signal(SIGPIPE, SIG_IGN);
  int exit_code = tps::cli::kDone;
  CLI::App app("Reference implementation and oracle of the tethered particle system.", "tps");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(kFooter);
  tps::cli::add_run(app, exit_code);
  tps::cli::add_check(app, exit_code);
  tps::cli::add_explain(app, exit_code);
  tps::cli::add_scene(app, exit_code);
  tps::cli::add_import(app, exit_code);
  tps::cli::add_draw(app, exit_code);
  tps::cli::add_claims(app, exit_code);
  tps::cli::add_eval(app, exit_code);
  tps::cli::add_vectors(app, exit_code);
  tps::cli::add_serve(app, exit_code);
  tps::cli::add_properties(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? tps::cli::kDone : tps::cli::kUsage;
  } catch (const tps::InputError& error) {
    return report(error.what(), tps::cli::kBadInput);
  } catch (const tps::OutputError& error) {
    return report(error.what(), tps::cli::kOutputFailed);
  } catch (const std::bad_alloc&) {
    return report("not enough memory for this input; give it in smaller parts", tps::cli::kBadInput);
  } catch (const std::exception& error) {
    return report((std::string("internal error, please report it: ") + error.what()).c_str(),
                  tps::cli::kInternal);
  }
}
