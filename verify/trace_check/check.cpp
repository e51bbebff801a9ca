#include "verify/trace_check/check.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "reference/run/run.hpp"
#include "reference/scene/file_kind.hpp"
#include "reference/scene/json_document.hpp"
#include "reference/scene/read_scene.hpp"
#include "verify/protocol/line_reader.hpp"
#include "verify/trace_check/judge_lines.hpp"

namespace tps::check {
namespace {

/// A header holds a scene, which is no longer than a scene file may be.
constexpr std::size_t kLongestHeader = std::size_t{64} << 20U;
/// What a particle can take of a full state: nine numbers of 100 digits, its tethers and loads.
constexpr std::size_t kStateOfParticle = 4096;

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& message) {
  throw InputError({{file, line, "", message}});
}

/// A file that is closed in the end; 0 is the standard input.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : number_(path == "-" ? 0 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (path != "-" && std::filesystem::is_directory(path))
      fail(path, 0, "is a directory; a trace is a file");
    if (number_ < 0) fail(path, 0, "cannot be opened; a trace is written by tps run SCENE -o TRACE");
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ > 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

struct Head {
  Scene scene;
  std::string scalar = "double";
  Timing timing = Timing::stable;
  bool minimal = false;
};

std::string text_at(const JsonValue& object, const char* key, const std::string& otherwise) {
  const JsonValue* value = object.find(key);
  if (value == nullptr) return otherwise;
  return value->string() != nullptr ? *value->string() : "";
}

Head read_head(std::string_view text, const std::string& file, const CheckOptions& options) {
  const JsonDocument document = parse_json(text, file);
  document.problems.throw_if_any();
  const JsonValue& root = document.root;
  if (root.find("checkpoint") != nullptr)
    fail(file, 1, "is a checkpoint; the check is for traces, which start with {\"trace\":1,…}");
  const JsonValue* version = root.find("trace");
  if (version == nullptr || version->number() == nullptr || version->number()->value != 1) {
    fail(file, 1, "is not the first line of a trace: {\"trace\":1,\"scalar\":…,\"scene\":{…}}");
  }
  static const std::vector<std::string> known = {"trace",   "semantics", "version", "scalar",
                                                 "options", "scene",     "form"};
  for (const JsonMember& member : *root.object()) {
    if (std::find(known.begin(), known.end(), member.key) == known.end()) {
      fail(file, 1,
           fmt::format("/{} is not known in a header; known are {}", member.key, fmt::join(known, ", ")));
    }
  }
  Head head;
  head.scalar = text_at(root, "scalar", "double");
  const auto scalar = scalar_kind(head.scalar);
  if (!scalar)
    fail(file, 1, fmt::format("/scalar \"{}\" is none of {}", head.scalar, fmt::join(scalar_names(), ", ")));
  const std::string form = text_at(root, "form", "full");
  if (form != "full" && form != "minimal")
    fail(file, 1, fmt::format("/form \"{}\" is neither \"full\" nor \"minimal\"", form));
  head.minimal = form == "minimal";
  if (const JsonValue* run_options = root.find("options")) {
    const std::string timing = text_at(*run_options, "timing", "stable");
    const auto kind = timing_named(timing);
    if (!kind || !can_be_timed(*scalar, *kind)) {
      fail(file, 1,
           fmt::format("/options/timing \"{}\" is none of {} (certified for float and double only)", timing,
                       fmt::join(timing_names(), ", ")));
    }
    head.timing = *kind;
  } else if (!head.minimal) {
    fail(file, 1, R"(lacks "options"; a trace of velocities only says "form":"minimal")");
  }
  const JsonValue* scene = root.find("scene");
  if (scene != nullptr) {
    head.scene = read_scene_value(*scene, file, "/scene");
  } else if (!options.scene.empty()) {
    head.scene = read_scene_file(options.scene);
  } else {
    fail(file, 1, "has no \"scene\", and none is given by --scene");
  }
  return head;
}

/// The first line and what follows it, as much as tells what a file is that begins like no trace.
std::string beginning_of(const std::string& first, protocol::LineReader& reader) {
  std::string beginning = first;
  while (beginning.size() < kBytesThatTell) {
    const protocol::LineReader::Result next = reader.next();
    if (next.status != protocol::LineReader::Status::line) break;
    beginning.append("\n").append(next.text);
  }
  return beginning;
}

CheckReport start_report(const std::string& path, const Head& head, double tolerance) {
  CheckReport report;
  report.file = path == "-" ? "standard input" : path;
  report.title = head.scene.title;
  for (char& c : report.title) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  report.scalar = head.scalar;
  report.timing = timing_names()[static_cast<std::size_t>(head.timing)];
  report.minimal = head.minimal;
  report.particles = head.scene.particles.size();
  report.tolerance = tolerance;
  for (const RuleFacts& facts : kRuleFacts)
    report.rules[static_cast<std::size_t>(facts.rule)].rule = facts.rule;
  return report;
}

void say_what_minimal_leaves_out(Tally& tally) {
  tally.not_judged(Rule::flight, "positions are judged where the trace has them");
  tally.not_judged(Rule::bystanders, "the trace has no velocities before events");
  tally.not_judged(Rule::states, "a minimal trace has no full states to judge");
  tally.not_judged(Rule::groups, "stored impulses are the check's own");
}

}  // namespace

CheckReport check_trace(const std::string& path, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::string file = path == "-" ? "standard input" : path;
  const Descriptor descriptor(path);
  bool interrupted = false;
  const auto stop = [&] { return options.interrupt != nullptr && options.interrupt->load(); };
  protocol::LineReader reader(
      descriptor.number(), kLongestHeader, [] {}, stop);
  const protocol::LineReader::Result first = reader.next();
  if (first.status == protocol::LineReader::Status::end)
    fail(file, 0, "is empty; a trace starts with {\"trace\":1,…}");
  if (first.status == protocol::LineReader::Status::too_long)
    fail(file, 1, "is longer than 64 MiB; a header is not");
  if (first.status == protocol::LineReader::Status::interrupted)
    fail(file, 0, "the check was interrupted before the header");
  const std::string header(first.text);
  if (header.find("\"trace\"") == std::string::npos) {
    refuse_other_kinds(beginning_of(header, reader), file, "a trace",
                       {FileKind::trace, FileKind::checkpoint});
  }
  const Head head = read_head(header, file, options);
  reader.set_longest_line(kLongestHeader + kStateOfParticle * head.scene.particles.size());

  CheckReport report = start_report(path, head, options.tolerance);
  report.lines = 1;
  Tally tally(report, options.tolerance, options.max_reports);
  tally.step.line = 1;
  tally.pass(Rule::schema);
  if (!options.scene.empty()) {
    tally.demand(Rule::schema, head.scene == read_scene_file(options.scene), [&](Finding& f) {
      f.message = fmt::format("the scene of the trace is not that of {}", options.scene);
    });
  }
  if (head.minimal) say_what_minimal_leaves_out(tally);

  std::uint64_t bytes = first.text.size();
  LineSource source{[&](LineSource::Text& line) {
    const protocol::LineReader::Result next = reader.next();
    interrupted = next.status == protocol::LineReader::Status::interrupted || stop();
    if (interrupted || next.status == protocol::LineReader::Status::end) return false;
    line = {next.text, next.status == protocol::LineReader::Status::too_long};
    ++report.lines;
    bytes += next.text.size();
    constexpr std::uint64_t kLinesBetweenReports = 4096;
    if (options.progress && report.lines % kLinesBetweenReports == 0)
      options.progress({bytes, report.events});
    return true;
  }};
  const TraceFacts facts{head.scene, head.timing, head.minimal};
  if (head.scalar == "float") {
    judge_lines<double>(source, facts, {0x1p-24L, 0x1p-149L, 24, true}, tally, report);
  } else if (head.scalar == "double") {
    judge_lines<double>(source, facts, {0x1p-53L, 0x1p-1074L, 53, false}, tally, report);
  } else {
    judge_wide_lines(source, facts, head.scalar, tally, report);
  }
  report.interrupted = interrupted;
  tally.close_sums();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tps::check
