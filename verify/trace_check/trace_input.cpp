#include "verify/trace_check/trace_input.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "reference/run/resume.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/json_document.hpp"
#include "reference/version.hpp"

namespace tps::check {
namespace {

/// A header holds a scene, which is no longer than a scene file may be.
constexpr std::size_t kLongestHeader = kSceneLimits.max_bytes;
/// What a particle can take of a full state: nine numbers of 100 digits, its tethers and loads.
constexpr std::size_t kStateOfParticle = 4096;

[[noreturn]] void fail(const std::string& file, std::size_t line, const std::string& message) {
  throw InputError({{file, line, "", message}});
}

std::string text_at(const JsonValue& object, const char* key, const std::string& otherwise) {
  const JsonValue* value = object.find(key);
  if (value == nullptr) return otherwise;
  return value->string() != nullptr ? *value->string() : "";
}

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
bool checksum_holds(const JsonValue& root, const TraceFileHead& head) {
  const JsonValue* stated = root.find("checksum");
  if (stated == nullptr) return true;
  TraceHead claimed{head.scene, head.semantics, *scalar_kind(head.scalar), head.timing, 0};
  const JsonValue* every = root.find("options")->find("state_every");
  if (every != nullptr && every->number() != nullptr) claimed.state_every = every->number()->magnitude;
  return stated->string() != nullptr && *stated->string() == head_checksum(claimed);
}

TraceFileHead read_head(std::string_view text, const std::string& file, const std::string& scene_file) {
  const JsonDocument document = parse_json(text, file, kSceneLimits);
  document.problems.throw_if_any();
  const JsonValue& root = document.root;
  if (root.find("checkpoint") != nullptr)
    fail(file, 1, "is a checkpoint; the check is for traces, which start with {\"trace\":1,…}");
  const JsonValue* version = root.find("trace");
  if (version != nullptr && version->number() != nullptr && version->number()->value != 1)
    fail(file, 1,
         fmt::format("/trace is {}; this check reads version 1 of traces", version->number()->value));
  if (version == nullptr || version->number() == nullptr) {
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
  TraceFileHead head;
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
    head.has_another_scene = !scene_file.empty() && head.scene != read_scene_file(scene_file);
  } else if (!scene_file.empty()) {
    head.scene = read_scene_file(scene_file);
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

int opened(const std::string& path) {
  std::error_code unknown;
  if (path != "-" && std::filesystem::is_directory(path, unknown))
    fail(path, 0, "is a directory; a trace is a file");
  const int descriptor = path == "-" ? 0 : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, 0, "cannot be opened; a trace is written by tps run SCENE -o TRACE");
  return descriptor;
}

bool is_file(int descriptor) {
  struct stat about = {};
  return ::fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode);
}

}  // namespace

TraceInput::Descriptor::~Descriptor() {
  if (number > 0) ::close(number);
}

TraceInput::TraceInput(const std::string& path, const std::string& scene_file, std::function<bool()> stop)
    : path_(path),
      descriptor_{opened(path)},
      can_be_reopened_(path != "-" && is_file(descriptor_.number)),
      stop_(std::move(stop)),
      reader_(
          path == "-" ? "standard input" : path, descriptor_.number, kLongestHeader, [] {}, stop_) {
  const std::string file = path == "-" ? "standard input" : path;
  const LineReader::Result first = reader_.next();
  if (first.status == LineReader::Status::end) fail(file, 0, "is empty; a trace starts with {\"trace\":1,…}");
  if (first.status == LineReader::Status::too_long) fail(file, 1, "is longer than 256 MiB; a header is not");
  if (first.status == LineReader::Status::interrupted)
    fail(file, 0, "reading was interrupted before the header");
  const std::string header(first.text);
  if (header.find("\"trace\"") == std::string::npos) {
    refuse_other_kinds(beginning_of(header, reader_), file, "a trace",
                       {FileKind::trace, FileKind::checkpoint});
  }
  head_ = read_head(header, file, scene_file);
  bytes_ = header.size();
  reader_.set_longest_line(longest_line());
}

std::size_t TraceInput::longest_line() const {
  return kLongestHeader + kStateOfParticle * head_.scene.particles.size();
}

bool TraceInput::next(LineText& line) {
  const LineReader::Result next = reader_.next();
  interrupted_ = next.status == LineReader::Status::interrupted || stop_();
  if (interrupted_ || next.status == LineReader::Status::end) return false;
  line = {next.text, next.status == LineReader::Status::too_long};
  ++lines_;
  bytes_ += next.text.size();
  return true;
}

TraceInput::Again::Again(const TraceInput& input, std::uint64_t place)
    : path_(input.path_),
      descriptor_{opened(path_)},
      reader_(
          path_, descriptor_.number, input.longest_line(), [] {}, [] { return false; }) {
  if (::lseek(descriptor_.number, static_cast<off_t>(place), SEEK_SET) < 0)
    fail(path_, 0, "cannot be read a second time; without --jobs it is read once");
}

LineText TraceInput::Again::next() {
  const LineReader::Result next = reader_.next();
  if (next.status == LineReader::Status::end)
    fail(path_, 0, "has become shorter while it was read; check it when it is not being written");
  return {next.text, next.status == LineReader::Status::too_long};
}

}  // namespace tps::check
