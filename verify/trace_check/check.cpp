#include "verify/trace_check/check.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "reference/run/resume.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/line_reader.hpp"
#include "reference/version.hpp"
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
    std::error_code unknown;
    if (path != "-" && std::filesystem::is_directory(path, unknown))
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

std::string text_at(const JsonValue& object, const char* key, const std::string& otherwise) {
  const JsonValue* value = object.find(key);
  if (value == nullptr) return otherwise;
  return value->string() != nullptr ? *value->string() : "";
}

struct Head {
  Scene scene;
  std::string scalar = "double";
  Timing timing = Timing::stable;
  bool minimal = false;
  int semantics = 0;      ///< 0: not said
  std::string positions;  ///< "lazy", "eager" or empty: not said
  bool own_draws = false;
  bool checksum_holds = true;  ///< where it has one
};

/// The version of the semantics that a trace names; what another one means is not known here.
int semantics_of(const JsonValue& root, const std::string& file) {
  const JsonValue* semantics = root.find("semantics");
  if (semantics == nullptr) return 0;
  const double version = semantics->number() == nullptr ? 0 : semantics->number()->value;
  if (!is_known_semantics(version)) {
    fail(file, 1,
         fmt::format("/semantics is none of the versions of docs/semantics.md that this check knows, {} to "
                     "{}; a trace "
                     "of another program may leave it out",
                     kOldestSemantics, kSemanticsVersion));
  }
  return static_cast<int>(version);
}

std::string one_of(const JsonValue& root, const char* key, const std::vector<std::string>& allowed,
                   const std::string& file) {
  if (root.find(key) == nullptr) return "";
  std::string text = text_at(root, key, "");
  if (std::find(allowed.begin(), allowed.end(), text) == allowed.end())
    fail(file, 1, fmt::format("/{} \"{}\" is none of {}", key, text.substr(0, 60), fmt::join(allowed, ", ")));
  return text;
}

/// True where there is none: then nothing is claimed.
bool checksum_holds(const JsonValue& root, const Head& head) {
  const JsonValue* stated = root.find("checksum");
  if (stated == nullptr) return true;
  TraceHead claimed{head.scene, head.semantics, *scalar_kind(head.scalar), head.timing, 0};
  const JsonValue* every = root.find("options")->find("state_every");
  if (every != nullptr && every->number() != nullptr) claimed.state_every = every->number()->magnitude;
  return stated->string() != nullptr && *stated->string() == head_checksum(claimed);
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
  static const std::vector<std::string> known = {"trace", "semantics", "version",   "scalar", "options",
                                                 "scene", "form",      "positions", "draws",  "checksum"};
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
  head.semantics = semantics_of(root, file);
  head.positions = one_of(root, "positions", {"lazy", "eager"}, file);
  // The page of semantics fixes the generator; who names neither may have another one.
  const std::string draws = one_of(root, "draws", {"philox", "recorded"}, file);
  head.own_draws = draws == "philox" || (draws.empty() && head.semantics > 0);
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
  head.checksum_holds = head.minimal || checksum_holds(root, head);
  return head;
}

/// The first line and what follows it, as much as tells what a file is that begins like no trace.
std::string beginning_of(const std::string& first, LineReader& reader) {
  std::string beginning = first;
  while (beginning.size() < kBytesThatTell) {
    const LineReader::Result next = reader.next();
    if (next.status != LineReader::Status::line) break;
    beginning.append("\n").append(next.text);
  }
  return beginning;
}

CheckReport start_report(const std::string& path, const Head& head, double tolerance) {
  CheckReport report;
  report.file = path == "-" ? "standard input" : path;
  report.title = head.scene.title;
  report.scalar = head.scalar;
  report.timing = timing_names()[static_cast<std::size_t>(head.timing)];
  report.minimal = head.minimal;
  report.particles = head.scene.particles.size();
  report.tolerance = tolerance;
  for (const RuleFacts& facts : kRuleFacts)
    report.rules[static_cast<std::size_t>(facts.rule)].rule = facts.rule;
  return report;
}

void say_what_minimal_leaves_out(Tally& tally, const Head& head) {
  tally.not_judged(Rule::flight, "positions are judged where the trace has them");
  tally.not_judged(Rule::bystanders, "the trace has no velocities before events");
  tally.not_judged(Rule::states, "a minimal trace has no full states to judge");
  if (head.scene.grouping) tally.not_judged(Rule::groups, "stored impulses are the check's own");
}

constexpr const char* kTakenAsEager =
    "positions are taken to be advanced and rounded for everybody at every event; \"positions\":\"eager\" in "
    "the "
    "header says so";

/// A trace that does not say how its positions are kept is judged both ways. @return whether the second is
/// the better one: nothing is violated then.
bool explains_more(const CheckReport& strict, const CheckReport& eager) {
  return strict.violated() > 0 && eager.violated() == 0;
}

void judge_header(Tally& tally, const Head& head, const CheckOptions& options) {
  tally.step.line = 1;
  tally.demand(Rule::schema, head.checksum_holds, [](Finding& f) {
    f.message =
        "/checksum is not that of scalar, options and scene: the line was damaged or edited (if it was "
        "edited, leave the checksum out)";
  });
  if (!options.scene.empty()) {
    tally.demand(Rule::schema, head.scene == read_scene_file(options.scene), [&](Finding& f) {
      f.message = fmt::format("the scene of the trace is not that of {}", options.scene);
    });
  }
  if (head.minimal) say_what_minimal_leaves_out(tally, head);
}

}  // namespace

CheckReport check_trace(const std::string& path, const CheckOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::string file = path == "-" ? "standard input" : path;
  const Descriptor descriptor(path);
  bool interrupted = false;
  const auto stop = [&] { return options.interrupt != nullptr && options.interrupt->load(); };
  LineReader reader(
      descriptor.number(), kLongestHeader, [] {}, stop);
  const LineReader::Result first = reader.next();
  if (first.status == LineReader::Status::end) fail(file, 0, "is empty; a trace starts with {\"trace\":1,…}");
  if (first.status == LineReader::Status::too_long) fail(file, 1, "is longer than 64 MiB; a header is not");
  if (first.status == LineReader::Status::interrupted)
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
  CheckReport eager_report = report;
  Tally tally(report, options.tolerance, options.max_reports);
  Tally eager_tally(eager_report, options.tolerance, options.max_reports);
  const TraceFacts facts{.scene = head.scene,
                         .timing = head.timing,
                         .minimal = head.minimal,
                         .semantics = head.semantics,
                         .eager = head.positions == "eager",
                         .own_draws = head.own_draws && !options.trust_draws};
  std::vector<Judgement> ways = {{facts, tally, report}};
  if (head.minimal && head.positions.empty()) {
    ways.push_back({facts, eager_tally, eager_report});
    ways.back().facts.eager = true;
  }
  for (const Judgement& way : ways) judge_header(way.tally, head, options);

  std::uint64_t bytes = first.text.size();
  LineSource source{[&](LineSource::Text& line) {
    const LineReader::Result next = reader.next();
    interrupted = next.status == LineReader::Status::interrupted || stop();
    if (interrupted || next.status == LineReader::Status::end) return false;
    line = {next.text, next.status == LineReader::Status::too_long};
    ++report.lines;
    bytes += next.text.size();
    constexpr std::uint64_t kLinesBetweenReports = 4096;
    if (options.progress && report.lines % kLinesBetweenReports == 0)
      options.progress({bytes, report.events});
    return true;
  }};
  if (head.scalar == "float") {
    judge_lines<double>(source, ways, {0x1p-24L, 0x1p-149L, 24, true});
  } else if (head.scalar == "double") {
    judge_lines<double>(source, ways, {0x1p-53L, 0x1p-1074L, 53, false});
  } else {
    judge_wide_lines(source, ways, head.scalar);
  }
  for (const Judgement& way : ways) way.tally.close_sums();
  if (ways.size() > 1 && explains_more(report, eager_report)) {
    eager_report.lines = report.lines;
    report = std::move(eager_report);
    report.notes.emplace_back(kTakenAsEager);
  }
  report.interrupted = interrupted;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace tps::check
