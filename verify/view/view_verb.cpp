// tps view
#include <fstream>
#include <memory>

#include "reference/process/interrupt.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/scratch_file.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/progress.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/view/page.hpp"

namespace tps::cli {
namespace {

struct ViewArguments {
  std::string file;
  std::string output = "-";
  std::string scene;
  std::uint64_t most_events = view::PlaybackOptions{}.most_events;
  bool quiet = false;
};

bool is_scene(const std::string& path) {
  if (path == "-") return false;
  refuse_other_kinds_of_file(path, "a trace or a scene", {FileKind::trace, FileKind::scene});
  std::string beginning(kBytesThatTell, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  return recognise_file(beginning).kind == FileKind::scene;
}

view::Playback played(const ViewArguments& a) {
  const interrupt::GoodOrder good_order;
  view::PlaybackOptions options;
  options.scene = a.scene;
  options.most_events = a.most_events;
  options.stop = [] { return interrupt::requested(); };
  if (!is_scene(a.file)) return view::read_playback(a.file, options);
  const ScratchFile trace;
  ProgressReport progress(a.quiet, "t");
  RunOptions run;
  run.trace = trace.path();
  run.max_events = a.most_events;
  run.interrupt = &interrupt::flag();
  run.progress = [&](const RunOptions::Progress& p) { progress.update({p.t, p.duration, p.events}); };
  run_scene(read_scene_file(a.file), run);
  return view::read_playback(trace.path(), options);
}

int run_view(const ViewArguments& a) {
  NamedFiles().reads("file", a.file).reads("--scene", a.scene).writes("-o", a.output).require_distinct();
  view::require_viewer();
  const view::Playback playback = played(a);
  if (interrupt::requested()) return kInterrupted;
  if (!a.quiet) {
    for (const std::string& note : playback.notes) say("tps: note: {}\n", note);
    if (playback.one_of > 1) {
      say("tps: note: the trace has {} events; the page has one in {}. --most-events N changes that\n",
          playback.all_events, playback.one_of);
    }
  }
  write_result(a.output, view::page(playback, {}));
  return kDone;
}

}  // namespace

void add_view(CLI::App& app, int& exit_code) {
  const auto a = std::make_shared<ViewArguments>();
  CLI::App* verb = app.add_subcommand(
      "view", "Writes a page that plays a trace in a browser; a scene is simulated first, in double.");
  verb->add_option("file", a->file, "Trace or scene file, - for a trace on standard input")->required();
  verb->add_option("-o,--output", a->output, "Write the page here")->capture_default_str();
  verb->add_option("--scene", a->scene, "The scene of a trace that lacks its own");
  verb->add_option("--most-events", a->most_events,
                   "Events that the page has at most: of a longer trace every second, fourth, … is kept")
      ->check(integer_from(2, "a number of events"))
      ->capture_default_str();
  verb->add_flag("-q,--quiet", a->quiet, "No progress and no notes on standard error");
  verb->footer(
      "The page is one file that loads nothing (docs/view.md). tps check TRACE --view FILE marks what the "
      "check "
      "objects to.\n"
      "Example: tps run data/scenes/terminal.json -o terminal.ndjson && tps view terminal.ndjson -o "
      "terminal.html");
  verb->callback([=, &exit_code] { exit_code = run_view(*a); });
}

}  // namespace tps::cli
