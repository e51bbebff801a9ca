#include "tests/trace_check/broken_trace.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>

#include "reference/scene/read_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"

namespace tps::mutation {
namespace {

HexDigits digits_of(const Json& hex) {
  return *split_hex(hex.get<std::string>());
}

/// a + b or a − b, all digits.
std::string exact_difference(const Json& b, const Json& a) {
  std::array<HexDigits, 2> terms = {digits_of(b), digits_of(a)};
  terms[1].negative = !terms[1].negative;
  return join_hex(exact_sum(terms));
}

std::string rounded(const Trace& trace, const std::string& hex) {
  if (trace.scalar == "float") return to_hex(std::strtof(hex.c_str(), nullptr));
  return to_hex(std::strtod(hex.c_str(), nullptr));
}

/// hi and lo of a time since the start.
Json two_parts(const Trace& trace, const std::string& since) {
  const std::string hi = rounded(trace, since);
  return Json::array({hi, rounded(trace, exact_difference(since, hi))});
}

struct Counted {
  std::uint64_t events = 0, progress_event = 0;
  std::string t, hi;
  std::map<std::string, std::uint64_t> by_kind;
};

/// Gives a line another value where it has not got it: only lines that change are copied.
void put(Trace& trace, std::size_t n, const char* key, const Json& value) {
  const auto had = trace.lines[n].find(key);
  if (had == trace.lines[n].end() || *had != value) trace.lines.change(n)[key] = value;
}

void settle_event(Trace& trace, std::size_t n, Counted& so_far, const std::string& start) {
  const Json& line = trace.lines[n];
  const std::string kind = line.at("kind");
  const std::string t = line.at("t");
  const std::string hi = rounded(trace, exact_difference(t, start));
  if (hi != so_far.hi) so_far.progress_event = so_far.events;
  put(trace, n, "k", ++so_far.events);
  put(trace, n, "dt", rounded(trace, exact_difference(t, so_far.t)));
  so_far.t = t;
  so_far.hi = hi;
  ++so_far.by_kind[kind];
}

void settle_state(Trace& trace, std::size_t n, const Counted& so_far, const std::string& start) {
  std::map<std::string, std::uint64_t> counts = so_far.by_kind;
  for (const auto& [kind, count] : trace.lines[n].at("counts").items()) {
    if (kind.starts_with('#')) counts[kind] = count;
  }
  const Json now = two_parts(trace, exact_difference(so_far.t, start));
  put(trace, n, "state", so_far.events);
  put(trace, n, "t", so_far.t);
  put(trace, n, "last_event", now);
  put(trace, n, "now", now);
  put(trace, n, "progress_event", so_far.progress_event);
  put(trace, n, "counts", counts);
}

}  // namespace

Trace trace_of(const std::string& bytes) {
  Trace trace;
  std::istringstream text(bytes);
  for (std::string line; std::getline(text, line);) {
    Json said = Json::parse(line);
    said.erase("checksum");  // who tells a lie does not leave a proof of it behind
    trace.lines.push_back(std::move(said));
  }
  const Json& head = trace.lines.front();
  trace.scalar = head.at("scalar");
  trace.scene = read_scene_text(head.at("scene").dump(), "the trace's scene");
  return trace;
}

std::string text_of(const Trace& trace) {
  std::string text = trace.lines.text();
  text.resize(text.size() - trace.torn);
  return text;
}

std::vector<std::size_t> event_lines(const Trace& trace) {
  std::vector<std::size_t> lines;
  for (std::size_t n = 0; n < trace.lines.size(); ++n) {
    if (is_event(trace.lines[n])) lines.push_back(n);
  }
  return lines;
}

void settle(Trace& trace) {
  const std::string start = to_hex(trace.scene.start_time);
  Counted so_far;
  so_far.t = start;
  so_far.hi = to_hex(0.);
  for (std::size_t n = 0; n < trace.lines.size(); ++n) {
    if (is_event(trace.lines[n])) settle_event(trace, n, so_far, start);
    if (is_state(trace.lines[n])) settle_state(trace, n, so_far, start);
    if (is_end(trace.lines[n])) {
      put(trace, n, "events", so_far.events);
      if (trace.lines[n].at("end") != "duration") put(trace, n, "t", so_far.t);
    }
  }
}

double number(const Json& hex) {
  const std::string& text = hex.get_ref<const std::string&>();
  const HexFloat exact = parse_hex_float(text);
  return exact.verdict == HexFloat::Verdict::exact ? exact.value : std::strtod(text.c_str(), nullptr);
}

Vec numbers(const Json& hexes) {
  Vec v(hexes.size());
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = number(hexes[k]);
  return v;
}

double dot(const Vec& a, const Vec& b) {
  return (a * b).sum();
}

double length(const Vec& v) {
  return std::sqrt(dot(v, v));
}

std::string spelt(const Trace& trace, double x) {
  return rounded(trace, to_hex(x));
}

Json spelt(const Trace& trace, const Vec& v) {
  Json hexes = Json::array();
  for (const double x : v) hexes.push_back(spelt(trace, x));
  return hexes;
}

double epsilon(const Trace& trace) {
  return trace.scalar == "float" ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                 : std::numeric_limits<double>::epsilon();
}

std::string stepped(const Trace& trace, const Json& hex, int ulps) {
  double x = number(hex);
  const double away = std::copysign(std::numeric_limits<double>::infinity(), x);
  for (int n = 0; n < ulps; ++n) {
    x = trace.scalar == "float"
            ? static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(away)))
            : std::nextafter(x, away);
  }
  return spelt(trace, x);
}

double elapsed(const Json& a, const Json& b) {
  return std::strtod(exact_difference(b, a).c_str(), nullptr);
}

double since_start(const Trace& trace, const Json& t) {
  return elapsed(to_hex(trace.scene.start_time), t);
}

std::string clock_time(const Trace& trace, double since) {
  const std::array<HexDigits, 2> terms = {hex_digits(trace.scene.start_time),
                                          *split_hex(spelt(trace, since))};
  return join_hex(exact_sum(terms));
}

}  // namespace tps::mutation
