#include "reference/run/trace_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "reference/run/resume.hpp"
#include "reference/run/time_since_start.hpp"
#include "reference/run/trace_lines.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/checksum.hpp"
#include "reference/text/fields.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/line_source.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/schema_words.hpp"
#include "reference/version.hpp"

namespace tps {
namespace {

[[noreturn]] void fail(const std::string& path, std::size_t line, const std::string& message) {
  throw InputError({{path, line, "", message}});
}

/// Reads a first line and checks that it is one.
JsonDocument head_of(const std::string& path) {
  refuse_other_kinds_of_file(path, "a trace or a checkpoint", {FileKind::trace, FileKind::checkpoint});
  TraceLines lines(path);
  if (!lines.next()) fail(path, 1, "holds no complete line; a trace starts with {\"trace\":1,…}");
  JsonDocument document = parse_json(lines.text, path, kSceneLimits);
  document.problems.throw_if_any();
  if (document.root.find("trace") == nullptr && document.root.find("checkpoint") == nullptr) {
    fail(path, 1,
         "is not the first line of a trace ({\"trace\":1,…}) or of a checkpoint ({\"checkpoint\":1,…})");
  }
  return document;
}

void require_version(const Field& head, const char* key, const char* what) {
  const std::uint64_t version = head.at(key).natural();
  if (version != 1) {
    head.at(key).refuse(fmt::format("is {}; this program reads version 1 of {}", version, what));
  }
}

/// The whole of a first line but its scene, read strictly.
TraceHead head_from(const Field& line) {
  TraceHead head;
  const bool checkpoint = line.has("checkpoint");
  if (line.has("form") && line.at("form").text() == "minimal") {
    line.at("form").refuse(
        "is \"minimal\": a minimal trace has no full states to draw or to go on from; tps check judges it, "
        "tps view plays it");
  }
  line.require_keys({checkpoint ? "checkpoint" : "trace", "semantics", "scalar", "options", "scene"},
                    {"version", "form", "checksum"});
  require_version(line, checkpoint ? "checkpoint" : "trace", checkpoint ? "checkpoints" : "traces");
  const Field semantics = line.at("semantics");
  const std::uint64_t version = semantics.natural();
  if (!is_known_semantics(static_cast<double>(version))) {
    semantics.refuse(fmt::format("is {}; this program knows {} to {} (docs/semantics.md)", version,
                                 kOldestSemantics, kSemanticsVersion));
  }
  head.semantics = static_cast<int>(version);
  const Field scalar = line.at("scalar");
  if (const auto kind = scalar_kind(scalar.text())) {
    head.scalar = *kind;
  } else {
    scalar.refuse(
        fmt::format("is {}; scalars are {}", describe_found(scalar.json()), fmt::join(scalar_names(), ", ")));
  }
  const Field options = line.at("options");
  options.require_keys({"state_every"}, {"timing"});
  head.state_every = options.at("state_every").natural();
  if (head.state_every == 0)
    options.at("state_every").refuse("is 0; full states are at least an event apart");
  if (!options.has("timing")) return head;  // from before there was a choice
  const Field timing = options.at("timing");
  const auto kind = timing_named(timing.text());
  if (!kind) {
    timing.refuse(fmt::format("is {}; it is one of {}", describe_found(timing.json()),
                              fmt::join(timing_names(), ", ")));
  }
  if (!can_be_timed(head.scalar, *kind))
    timing.refuse("is certified in a scalar other than float and double, which no run has");
  head.timing = *kind;
  return head;
}

}  // namespace

bool is_known_semantics(double version) {
  return version >= kOldestSemantics && version <= kSemanticsVersion && std::trunc(version) == version;
}

std::string head_checksum(const TraceHead& head) {
  return checksum_of(fmt::format("{}\n{}\n{}\n{}", scalar_names()[static_cast<std::size_t>(head.scalar)],
                                 timing_names()[static_cast<std::size_t>(head.timing)], head.state_every,
                                 write_scene(head.scene, SceneStyle::compact)));
}

std::string head_line(std::string_view kind, const Scene& scene, const RunOptions& options,
                      std::uint64_t state_every) {
  nlohmann::ordered_json head{
      {kind, 1},
      {"semantics", kSemanticsVersion},
      {"version", version()},
      {"scalar", scalar_names()[static_cast<std::size_t>(options.scalar)]},
      {"options",
       {{"timing", timing_names()[static_cast<std::size_t>(options.timing)]}, {"state_every", state_every}}}};
  std::string line = json_text(head);
  line.pop_back();
  line.append(",\"scene\":").append(write_scene(scene, SceneStyle::compact));
  const std::string checksum =
      head_checksum({scene, kSemanticsVersion, options.scalar, options.timing, state_every});
  return line.append(",\"checksum\":\"").append(checksum).append("\"}\n");
}

TraceHead read_trace_head(const std::string& path) {
  const JsonDocument document = head_of(path);
  const Field line(document.root, path);
  TraceHead head = head_from(line);
  head.scene = read_scene_value(line.at("scene").json(), path, "/scene");
  if (line.has("checksum") && line.at("checksum").text() != head_checksum(head)) {
    line.at("checksum")
        .refuse(
            "is not that of scalar, options and scene, so that the line was damaged or edited; if it was "
            "edited, "
            "leave the checksum out");
  }
  return head;
}

bool is_checkpoint(const std::string& path) {
  return head_of(path).root.find("checkpoint") != nullptr;
}

ResumePoint last_state(const std::string& path) {
  TraceLines lines(path);
  TraceOrder order;
  std::string text;
  ResumePoint point;
  point.from = path;
  std::size_t number = 0;
  std::uint64_t before = 0;
  std::uint64_t start = 0;
  std::uint64_t end = 0;
  while (lines.next()) {
    if (order.next(lines).what == TraceLineKind::What::state) {
      order.require_sound();
      text = lines.text;
      number = lines.number;
      start = before;
      end = lines.end;
    }
    before = lines.end;
  }
  if (text.empty()) fail(path, 0, "holds no full state to resume from; start the run again");
  point.state = read_state(text, path, number);
  point.keep = point.state.final ? start : end;
  return point;
}

StateData last_state_until(const std::string& path, const Scene& scene, std::optional<double> until) {
  if (!until) return last_state(path).state;
  TraceLines lines(path);
  TraceOrder order;
  std::optional<StateData> found;
  while (lines.next()) {
    if (order.next(lines).what != TraceLineKind::What::state) continue;
    order.require_sound();
    StateData state = lines.state();
    if (time_since_start(scene, state.now) > *until) break;
    found = std::move(state);
  }
  if (!found) fail(path, 0, "holds no full state up to that time");
  return *found;
}

std::uint64_t place_behind_state(const std::string& path, std::uint64_t k) {
  TraceLines lines(path);
  TraceOrder order;
  std::uint64_t start = 0;
  while (lines.next()) {
    const TraceLineKind kind = order.next(lines);
    if (kind.what == TraceLineKind::What::state && kind.k == k) {
      order.require_sound();
      return lines.state().final ? start : lines.end;
    }
    start = lines.end;
  }
  fail(path, 0,
       "holds no full state after event " + std::to_string(k) +
           ", where the checkpoint was taken; resume from the trace itself, or leave out -o");
}

TraceFiles::TraceFiles(const RunOptions& options, const ResumePoint* resume) {
  if (!options.checkpoint.empty()) checkpoint_.emplace(options.checkpoint);
  if (options.trace.empty()) return;
  trace_ = resume != nullptr && resume->trace != nullptr
               ? resume->trace
               : std::make_shared<Output>(options.trace, Output::Reserve::only);
  trace_->write_in_background();
}

void TraceFiles::begin(const Scene& scene, const RunOptions& options, std::uint64_t state_every,
                       const ResumePoint* resume) {
  if (checkpoint_) checkpoint_head_ = head_line("checkpoint", scene, options, state_every);
  if (!trace_) return;
  std::error_code ignored;
  if (resume != nullptr && std::filesystem::equivalent(resume->from, options.trace, ignored))
    return trace_->begin(resume->keep);
  trace_->begin();
  if (resume == nullptr) return trace_->write(head_line("trace", scene, options, state_every));
  std::ifstream from(resume->from, std::ios::binary);
  std::string block(1U << 16U, '\0');
  for (std::uint64_t left = resume->keep; left > 0 && from;) {
    from.read(block.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(left, block.size())));
    trace_->write(std::string_view(block).substr(0, static_cast<std::size_t>(from.gcount())));
    left -= static_cast<std::uint64_t>(from.gcount());
  }
}

void TraceFiles::line(std::string_view text) {
  trace_->write(text);
  trace_->write("\n");
}

void TraceFiles::lines(MakeText make) {
  trace_->write(std::move(make));
}

void TraceFiles::state(MakeText make) {
  if (!checkpoint_) return lines(std::move(make));
  std::string text = checkpoint_head_;
  make(text);
  if (trace_) {
    trace_->write(std::string_view(text).substr(checkpoint_head_.size()));
    trace_->flush();  // a checkpoint is never ahead of its trace
  }
  checkpoint_->replace(text);
}

void TraceFiles::send() {
  if (trace_) trace_->send();
}

void TraceFiles::settle() noexcept {
  if (trace_) trace_->settle();
}

void TraceFiles::close() {
  if (trace_) trace_->close();
}

}  // namespace tps
