#include "reference/run/trace_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "reference/scene/file_kind.hpp"
#include "reference/scene/input_error.hpp"
#include "reference/scene/json_document.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/version.hpp"

namespace tps {
namespace {

[[noreturn]] void fail(const std::string& path, std::size_t line, const std::string& message) {
  throw InputError({{path, line, "", message}});
}

/// Complete lines of a file, with the place behind each. A last line without an end was cut off while it was
/// written and does not count.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), in_(path, std::ios::binary) {
    if (std::filesystem::is_directory(path))
      fail(path, 0, "is a directory; a trace or checkpoint file is wanted");
    if (!in_) fail(path, 0, "cannot be opened; a trace or checkpoint file is wanted");
  }

  bool next() {
    if (!std::getline(in_, text) || in_.eof()) return false;
    ++number;
    end += text.size() + 1;
    return true;
  }

  std::string text;
  std::size_t number = 0;
  std::uint64_t end = 0;

 private:
  std::string path_;
  std::ifstream in_;
};

constexpr std::string_view kStateStart = "{\"state\":";

StateData state_of(const std::string& path, const Lines& lines) {
  try {
    return read_state(lines.text);
  } catch (const std::exception& error) {
    fail(path, lines.number, std::string("is not a full state: ") + error.what());
  }
}

/// Reads a first line and checks that it is one.
nlohmann::json head_of(const std::string& path) {
  refuse_other_kinds_of_file(path, "a trace or a checkpoint", {FileKind::trace, FileKind::checkpoint});
  Lines lines(path);
  if (!lines.next()) fail(path, 1, "holds no complete line; a trace starts with {\"trace\":1,…}");
  const nlohmann::json head = nlohmann::json::parse(lines.text, nullptr, false);
  if (!head.is_object() || !(head.contains("trace") || head.contains("checkpoint"))) {
    fail(path, 1,
         "is not the first line of a trace ({\"trace\":1,…}) or of a checkpoint ({\"checkpoint\":1,…})");
  }
  return head;
}

}  // namespace

std::string head_line(std::string_view kind, const Scene& scene, const RunOptions& options,
                      std::uint64_t state_every) {
  nlohmann::ordered_json head{
      {kind, 1},
      {"semantics", kSemanticsVersion},
      {"version", version()},
      {"scalar", scalar_names()[static_cast<std::size_t>(options.scalar)]},
      {"options",
       {{"timing", timing_names()[static_cast<std::size_t>(options.timing)]}, {"state_every", state_every}}}};
  std::string line = head.dump();
  line.pop_back();
  return line.append(",\"scene\":").append(write_scene(scene, SceneStyle::compact)).append("}\n");
}

TraceHead read_trace_head(const std::string& path) {
  const nlohmann::json head = head_of(path);
  try {
    TraceHead result;
    const std::optional<ScalarKind> scalar = scalar_kind(head.at("scalar").get<std::string>());
    if (!scalar)
      fail(path, 1, "names the scalar '" + head.at("scalar").get<std::string>() + "', which is unknown");
    result.scalar = *scalar;
    const nlohmann::json& options = head.at("options");
    const std::string timing_name = options.value("timing", "stable");
    const std::optional<Timing> timing = timing_named(timing_name);
    if (!timing) {
      fail(path, 1,
           "names the timing '" + timing_name + "', which is unknown; it is one of paper, stable, certified");
    }
    if (!can_be_timed(result.scalar, *timing)) {
      fail(path, 1, "has certified timing in a scalar other than float and double, which no run has");
    }
    result.timing = *timing;
    result.state_every = options.at("state_every");
    result.scene = read_scene_text(head.at("scene").dump(), path + " (scene in the first line)");
    return result;
  } catch (const nlohmann::json::exception& error) {
    fail(path, 1, std::string("lacks something that a trace begins with: ") + error.what());
  }
}

bool is_checkpoint(const std::string& path) {
  return head_of(path).contains("checkpoint");
}

ResumePoint last_state(const std::string& path) {
  static_cast<void>(head_of(path));
  Lines lines(path);
  std::string text;
  ResumePoint point;
  point.from = path;
  std::size_t number = 0;
  std::uint64_t before = 0;
  std::uint64_t start = 0;
  std::uint64_t end = 0;
  while (lines.next()) {
    if (lines.text.starts_with(kStateStart)) {
      text = lines.text;
      number = lines.number;
      start = before;
      end = lines.end;
    }
    before = lines.end;
  }
  if (text.empty()) fail(path, 0, "holds no full state to resume from; start the run again");
  lines.text = text;
  lines.number = number;
  point.state = state_of(path, lines);
  point.keep = point.state.final ? start : end;
  return point;
}

StateData last_state_until(const std::string& path, std::optional<double> until) {
  if (!until) return last_state(path).state;
  Lines lines(path);
  std::optional<StateData> found;
  while (lines.next()) {
    if (!lines.text.starts_with(kStateStart)) continue;
    StateData state = state_of(path, lines);
    if (std::strtod(state.now[0].c_str(), nullptr) > *until) break;
    found = std::move(state);
  }
  if (!found) fail(path, 0, "holds no full state up to that time");
  return *found;
}

std::uint64_t place_behind_state(const std::string& path, std::uint64_t k) {
  Lines lines(path);
  std::uint64_t start = 0;
  while (lines.next()) {
    if (lines.text.starts_with(kStateStart)) {
      const StateData state = state_of(path, lines);
      if (state.k == k) return state.final ? start : lines.end;
    }
    start = lines.end;
  }
  fail(path, 0,
       "holds no full state after event " + std::to_string(k) +
           ", where the checkpoint was taken; resume from the trace itself, or leave out -o");
}

TraceFiles::TraceFiles(const Scene& scene, const RunOptions& options, std::uint64_t state_every,
                       const ResumePoint* resume)
    : checkpoint_(options.checkpoint) {
  if (!checkpoint_.empty()) checkpoint_head_ = head_line("checkpoint", scene, options, state_every);
  if (options.trace.empty()) return;
  if (resume == nullptr) {
    trace_ = std::make_unique<Output>(options.trace);
    trace_->write(head_line("trace", scene, options, state_every));
    return;
  }
  std::error_code ignored;
  if (!std::filesystem::equivalent(resume->from, options.trace, ignored)) {
    std::ifstream from(resume->from, std::ios::binary);
    trace_ = std::make_unique<Output>(options.trace);
    std::string block(1U << 16U, '\0');
    for (std::uint64_t left = resume->keep; left > 0 && from;) {
      from.read(block.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(left, block.size())));
      trace_->write(std::string_view(block).substr(0, static_cast<std::size_t>(from.gcount())));
      left -= static_cast<std::uint64_t>(from.gcount());
    }
    return;
  }
  trace_ = std::make_unique<Output>(options.trace, resume->keep);
}

void TraceFiles::line(std::string_view text) {
  trace_->write(text);
  trace_->write("\n");
}

void TraceFiles::state(const std::string& text) {
  if (trace_) line(text);
  if (checkpoint_.empty()) return;
  if (trace_) trace_->flush();  // a checkpoint is never ahead of its trace
  replace_file(checkpoint_, checkpoint_head_ + text + "\n");
}

void TraceFiles::flush() {
  if (trace_) trace_->flush();
}

void TraceFiles::close() {
  if (trace_) trace_->close();
}

}  // namespace tps
