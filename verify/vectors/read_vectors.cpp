#include "verify/vectors/read_vectors.hpp"

#include <fmt/format.h>

#include <new>
#include <nlohmann/json.hpp>
#include <optional>

namespace tps::vectors {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20U;

/// Like std::getline, without taking more than it will keep. False at the end.
bool read_line(std::istream& in, std::string& line, bool& too_long) {
  line.clear();
  too_long = false;
  std::streambuf& source = *in.rdbuf();
  constexpr int end = std::char_traits<char>::eof();
  int c = source.sbumpc();
  if (c == end) return false;
  for (; c != end && c != '\n'; c = source.sbumpc()) {
    if (line.size() < longest_line) {
      line.push_back(static_cast<char>(c));
    } else {
      too_long = true;
    }
  }
  return true;
}

/// The cases of one header.
class Section {
 public:
  explicit Section(const Json& header)
      : op(header.at("op").get<std::string>()), announced_(header.at("count").get<std::uint64_t>()) {}

  std::optional<std::string> missing() const {
    if (read == announced_) return std::nullopt;
    return fmt::format("{} cases where the header announces {}; the file is truncated or was edited", read,
                       announced_);
  }

  std::string op;
  std::uint64_t read = 0;

 private:
  std::uint64_t announced_;
};

}  // namespace

void read_vectors(std::istream& in, const std::string& name, const VectorsVisitor& visitor) {
  std::optional<Section> section;
  std::string line;
  bool too_long = false;
  Place place{name, 0};
  const auto close_section = [&] {
    if (!section) return;
    if (const std::optional<std::string> problem = section->missing()) visitor.problem(*problem, place);
  };
  while (read_line(in, line, too_long)) {
    ++place.line;
    if (too_long) {
      visitor.problem(fmt::format("the line is longer than {} bytes; no case is", longest_line), place);
      continue;
    }
    try {
      const Json json = Json::parse(line);
      if (json.contains("schema")) {
        close_section();
        section.emplace(json);
        continue;
      }
      if (!section) throw std::invalid_argument("a case before any header line");
      ++section->read;
      visitor.known_case(section->op, json, place);
    } catch (const nlohmann::json::exception& error) {
      visitor.problem(error.what(), place);
    } catch (const std::invalid_argument& error) {
      visitor.problem(error.what(), place);
    } catch (const std::bad_alloc&) {
      visitor.problem("not enough memory for this case", place);
    }
  }
  if (!section)
    visitor.problem("no header line; a known-answer file begins with {\"schema\":\"vectors\",…}", place);
  close_section();
}

}  // namespace tps::vectors
