#include "reference/run/trace_lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "reference/text/checksum.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/line_source.hpp"

namespace tps {
namespace {

using What = TraceLineKind::What;

constexpr std::size_t kLongestHead = std::size_t{64} << 20U;   // holds a scene, which is no longer
constexpr std::size_t kLongestLine = std::size_t{512} << 20U;  // a full state of a million particles

[[noreturn]] void refuse(const std::string& path, std::size_t line, const std::string& message) {
  throw InputError({{path, line, "", message}});
}

/// Whether a text is one object from its first byte to its last, by its brackets, quotes and bytes. A parser
/// would see more, at a tenth of the speed: a trace has gigabytes.
bool is_whole_object(std::string_view text) {
  if (!text.starts_with('{') || !text.ends_with('}')) return false;
  std::string open;
  bool quoted = false;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char c = text[n];
    if (static_cast<unsigned char>(c) < ' ') return false;
    if (quoted) {
      if (c == '\\') ++n;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      open.push_back(c == '{' ? '}' : ']');
    } else if (c == '}' || c == ']') {
      if (open.empty() || open.back() != c) return false;
      open.pop_back();
      if (open.empty() && n + 1 < text.size()) return false;
    }
  }
  return open.empty() && !quoted;
}

/// The number behind a beginning such as {"k":, if the text has that beginning.
std::optional<std::uint64_t> number_behind(std::string_view text, std::string_view beginning) {
  if (!text.starts_with(beginning)) return std::nullopt;
  std::uint64_t number = 0;
  const char* const first = text.data() + beginning.size();
  const auto [end, error] = std::from_chars(first, text.data() + text.size(), number);
  const bool whole = error == std::errc() && (*end == ',' || *end == '}');
  return whole ? std::optional(number) : std::nullopt;
}

/// As our runs spell it; std::nullopt otherwise.
std::optional<TraceLineKind> quick_kind(std::string_view text) {
  if (const auto k = number_behind(text, "{\"k\":")) return TraceLineKind{What::event, *k};
  if (const auto k = number_behind(text, "{\"state\":")) return TraceLineKind{What::state, *k};
  if (text.starts_with("{\"end\":")) return TraceLineKind{What::end};
  return std::nullopt;
}

/// However it is spelt. Throws InputError where it is no JSON.
TraceLineKind kind_of(const TraceLines& lines) {
  if (const auto quick = quick_kind(lines.text)) return *quick;
  const JsonDocument document = parse_json(lines.text, lines.path(), {}, lines.number);
  for (const auto& [key, what] : {std::pair{"state", What::state}, std::pair{"k", What::event}}) {
    const JsonValue* value = document.root.find(key);
    if (value == nullptr || value->number() == nullptr) continue;
    if (value->number()->integer == JsonNumber::Integer::natural) return {what, value->number()->magnitude};
  }
  return {document.root.find("end") != nullptr ? What::end : What::other};
}

/// By the bytes where the line is spelt as ours are, else by its content.
std::string damage_in_state(const TraceLines& lines) {
  constexpr std::string_view kKey = ",\"checksum\":\"";
  const std::size_t at = lines.text.rfind(kKey);
  if (at != std::string::npos) {
    const std::string_view stored = std::string_view(lines.text).substr(at + kKey.size());
    const std::string content = lines.text.substr(0, at) + "}";
    if (stored == checksum_of(content) + "\"}") return {};
  }
  try {
    if (lines.state().checksum != StateData::Checksum::wrong) return {};
    return "is a state with the checksum of another";
  } catch (const InputError& error) {
    return error.problems().front().message;
  }
}

}  // namespace

TraceLines::TraceLines(const std::string& path) : path_(path), in_(path, std::ios::binary) {
  std::error_code unknown;  // a loop of links, a name too long: cannot be opened either
  if (std::filesystem::is_directory(path, unknown))
    refuse(path, 0, "is a directory; a trace or checkpoint file is wanted");
  if (!in_) refuse(path, 0, "cannot be opened; a trace or checkpoint file is wanted");
}

bool TraceLines::next() {
  LineRead read;
  const std::size_t longest = number == 0 ? kLongestHead : kLongestLine;
  if (!read_line(in_, text, longest, read) || !read.ended) return false;
  ++number;
  if (read.too_long) refuse(path_, number, fmt::format("is longer than {} bytes; no line is", longest));
  end += text.size() + 1;
  return true;
}

StateData TraceLines::state() const {
  return read_state(text, path_, number);
}

TraceLineKind TraceOrder::next(const TraceLines& lines) {
  if (lines.number == 1) return {What::head};
  TraceLineKind kind;
  note({lines.path(), lines.number, damage(lines, kind)});
  if (kind.what == What::state) {
    note(suspect_);
    suspect_ = {lines.path(), lines.number, damage_in_state(lines)};
  }
  return kind;
}

void TraceOrder::note(const Damage& found) {
  if (damage_.what.empty()) damage_ = found;
}

std::string TraceOrder::damage(const TraceLines& lines, TraceLineKind& kind) {
  kind = quick_kind(lines.text).value_or(kind);
  if (ended_) return "stands behind the end of the trace";
  if (!is_whole_object(lines.text)) return "is no whole JSON object";
  try {
    kind = kind_of(lines);
  } catch (const InputError& error) {
    return error.problems().front().message;
  }
  ended_ = kind.what == What::end;
  const std::uint64_t before = events_.value_or(kind.what == What::state ? kind.k : 0);
  if (kind.what == What::event) {
    events_ = kind.k;
    if (kind.k != before + 1)
      return fmt::format("is event {} behind event {}; lines are missing or doubled", kind.k, before);
  }
  if (kind.what == What::state) {
    events_ = kind.k;
    if (kind.k != before)
      return fmt::format("is the state after {} events, but there were {}", kind.k, before);
  }
  if (kind.what == What::other) return "is neither an event nor a state nor the end";
  return {};
}

void TraceOrder::require_sound() const {
  if (damage_.what.empty()) return;
  refuse(damage_.path, damage_.line,
         fmt::format("{}: the file was damaged here, so what stands behind is not what its run left; cut it "
                     "off before this line (head -n {}), and go on from there: the rest is simulated again",
                     damage_.what, damage_.line - 1));
}

}  // namespace tps
