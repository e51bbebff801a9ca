#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "properties/explore/regressions.hpp"
#include "properties/implementations/read_reply.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "reference/trace/check_state.hpp"
#include "reference/trace/state_data.hpp"
#include "tests/fuzz/run_and_check.hpp"
#include "verify/import/arslab_tps.hpp"
#include "verify/protocol/conversation.hpp"
#include "verify/trace_check/read_line.hpp"
#include "verify/vectors/check_answers.hpp"
#include "verify/vectors/read_vectors.hpp"

namespace tps::fuzz {
namespace {

void promise(bool kept, const char* what) {
  if (!kept) throw std::logic_error(what);
}

/// Messages are lines of bounded length that a terminal may show.
void promise_message(const InputError& error) {
  constexpr std::size_t kLongest = 4096;
  for (const InputProblem& problem : error.problems()) {
    const std::string line = format_problem(problem);
    promise(line.size() <= kLongest, "a message is a line of bounded length");
    promise(printable(line) == line, "a message can be printed");
  }
}

template <typename Read>
void reads_or_refuses(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    promise_message(error);
  }
}

void feed_json(std::string_view bytes) {
  reads_or_refuses([&] {
    const nlohmann::ordered_json value = parse_plain_json(bytes, "fuzz");
    const std::string text = json_text(value);
    promise(parse_plain_json(text, "again") == value, "JSON that is written is read as it was");
  });
}

void feed_scene(std::string_view bytes) {
  reads_or_refuses([&] {
    const Scene scene = read_scene_text(bytes, "fuzz");
    promise(read_scene_text(write_scene(scene, SceneStyle::compact), "again") == scene,
            "a scene that is written is read as it was");
  });
}

/// The scene that the seeds of states and lines belong to (corpus/scene/grouped.json in short).
const Scene& small_scene() {
  static const Scene scene = read_scene_text(
      R"({"tps":1,"dimension":2,"duration":10,"grouping":{"dt_restitute":0.01},)"
      R"("species":{"A":{"mass":1,"radius":0.5,"max_tethers":2},"W":{"mass":"inf","radius":0.5}},)"
      R"("pairs":[{"between":["A","A"],"blocking":{"c_rebound":1},"tethering":{"distance":2,"c_retract":0.5,"c_revolve":1,"theta_revolve_deg":45}},)"
      R"({"between":["A","W"],"blocking":{"c_rebound":1}}],)"
      R"("particles":[{"id":0,"species":"A","position":[0,0],"velocity":[1,0]},)"
      R"({"id":1,"species":"A","position":[1.5,0],"velocity":[0,0]},)"
      R"({"id":2,"species":"A","position":[3,0],"velocity":[0,0]},)"
      R"({"id":7,"species":"W","position":[6,0],"velocity":[0,0]}],"tethers":[[0,1]]})",
      "small scene");
  return scene;
}

void feed_state(std::string_view bytes) {
  reads_or_refuses([&] {
    const StateData state = read_state(bytes);
    const std::string written = write_state(state, state.t);
    const StateData again = read_state(written);
    promise(again.checksum == StateData::Checksum::right, "a state that is written carries its checksum");
    promise(write_state(again, again.t) == written, "a state that is written is read as it was");
    for (const StateProblem& problem : state_problems(small_scene(), state, 53))
      promise(!problem.message.empty(), "a problem has words");
  });
}

void feed_trace_line(std::string_view bytes) {
  static check::LineReading<double> reading(small_scene(), false, 53);
  static check::LineReading<double> minimal(small_scene(), true, 53);
  for (check::LineReading<double>* each : {&reading, &minimal}) {
    try {
      each->read(bytes);
    } catch (const check::LineProblem&) {
      // What a line that is none gets.
    }
  }
}

void feed_vectors(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  vectors::read_vectors(in, "fuzz",
                        {[](const std::string&, const vectors::Json&, const vectors::Place&) {},
                         [](const std::string& problem, const vectors::Place&) {
                           promise(!problem.empty(), "a problem has words");
                         }});
}

void feed_request(std::string_view bytes) {
  const protocol::Reply reply = protocol::reply_to(bytes);
  if (reply.last) return;
  promise(parse_plain_json(reply.text, "reply").is_object(), "a reply is an object");
  promise(reply.text.find("\"internal\"") == std::string::npos, "no error of ours");
}

void feed_reply(std::string_view bytes) {
  const properties::Answer answer = properties::read_reply(bytes, 1);
  promise(printable(answer.reason) == answer.reason, "what another program said can be printed");
}

void feed_regressions(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  reads_or_refuses([&] { properties::read_regressions(in, "fuzz"); });
}

void feed_hexfloat(std::string_view bytes) {
  const HexFloat strict = parse_hex_float(bytes);
  const std::optional<double> wide = from_hex<double>(bytes);
  promise((strict.verdict == HexFloat::Verdict::malformed) == !hex_spelling(bytes), "there is one grammar");
  if (wide && std::isfinite(*wide))
    promise(strict.verdict == HexFloat::Verdict::exact && strict.value == *wide,
            "both readers of hexadecimal floats agree");
  if (wide && std::isfinite(*wide))
    promise(from_hex<double>(to_hex(*wide)) == wide, "what is written is read");
  if (const std::optional<HexDigits> digits = split_hex(bytes))
    promise(join_hex(*split_hex(join_hex(*digits))) == join_hex(*digits), "one spelling");
}

void feed_import(std::string_view bytes) {
  reads_or_refuses([&] {
    const arslab::ImportedScene imported =
        arslab::import_scenario(parse_json(bytes, "fuzz", arslab::import_limits), {});
    read_scene_text(write_scene(imported.scene, SceneStyle::pretty), "imported");
  });
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {{"json", feed_json},         {"scene", feed_scene},
                                          {"state", feed_state},       {"trace_line", feed_trace_line},
                                          {"vectors", feed_vectors},   {"request", feed_request},
                                          {"reply", feed_reply},       {"regressions", feed_regressions},
                                          {"hexfloat", feed_hexfloat}, {"import", feed_import},
                                          {"run_check", run_and_check}};
  return all;
}

const Target* find_target(std::string_view name) {
  const auto found =
      std::find_if(targets().begin(), targets().end(), [&](const Target& t) { return t.name == name; });
  return found == targets().end() ? nullptr : &*found;
}

}  // namespace tps::fuzz
