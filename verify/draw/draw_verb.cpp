// tps draw
#include <cmath>
#include <memory>
#include <optional>

#include "reference/run/snapshot.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/draw/draw_svg.hpp"
#include "verify/draw/seen_from.hpp"

namespace tps::cli {

void add_draw(CLI::App& app, int&) {
  struct Arguments {
    std::string trace;
    std::string output = "-";
    std::optional<double> at;
    double size = DrawOptions{}.size;
    std::string from = "z";
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* verb =
      app.add_subcommand("draw", "Draws a full state of a trace, or a scene's start, as an SVG picture.");
  verb->add_option("file", a->trace, "Trace, checkpoint or scene file")->required();
  verb->add_option("-o,--output", a->output, "Write the picture here")->capture_default_str();
  verb->add_option("--at", a->at,
                   "The last full state up to this time since the start (default: the last one)")
      ->check(number_from(0, HUGE_VAL, "a time"));
  verb->add_option("--size", a->size, "Width in pixels")
      ->check(number_from(64, 16384, "a width"))
      ->capture_default_str();
  verb->add_option(
          "--from", a->from,
          "The axis that points to the viewer; from y the picture's right is z and its top x, from x "
          "they are y and z")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->capture_default_str();
  verb->footer(
      "Example: tps run data/scenes/terminal.json -o terminal.ndjson && tps draw terminal.ndjson -o end.svg");
  verb->callback([a] {
    NamedFiles().reads("file", a->trace).writes("-o", a->output).require_distinct();
    const Snapshot snapshot = read_snapshot(a->trace, a->at);
    DrawOptions options;
    options.size = a->size;
    options.time = snapshot.t;
    const auto axis = static_cast<std::size_t>(a->from.front() - 'x');
    if (snapshot.scene.dimension == 2 && axis != 2)
      throw CLI::ValidationError("--from " + a->from + ": " + a->trace +
                                 " lies in the plane of x and y and is seen from z");
    std::vector<Coordinates> places = snapshot.positions;
    for (Coordinates& place : places) place = seen_from(axis, place);
    write_result(a->output, draw_svg(seen_from(axis, snapshot.scene), places, snapshot.tethers, options));
  });
}

}  // namespace tps::cli
