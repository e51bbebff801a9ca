#include "verify/vectors/read_vectors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "reference/text/input_error.hpp"
#include "reference/text/line_source.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "reference/version.hpp"
#include "verify/vectors/generate.hpp"

namespace tps::vectors {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20U;
constexpr std::size_t longest_reason = 300;

/// The cases of one header.
class Section {
 public:
  /// Throws std::invalid_argument for a header that is none of this version.
  explicit Section(const Json& header) : op(header.at("op").get<std::string>()) {
    if (header.at("schema") != "vectors") throw std::invalid_argument("schema is not \"vectors\"");
    require(header, "version", kVectorsVersion, kVectorsVersion);
    require(header, "semantics", kOldestSemantics, kSemanticsVersion);
    for (const auto& [key, value] : header.items()) {
      static const std::set<std::string> known{"schema", "version",   "semantics", "op",    "stratum",
                                               "why",    "generator", "seed",      "first", "count"};
      if (!known.contains(key)) throw std::invalid_argument("a header has no key " + shown(key));
    }
    const Json& count = header.at("count");
    if (!count.is_number_unsigned())
      throw std::invalid_argument("count is " + shown(count) + "; it is a number of cases");
    announced_ = count.get<std::uint64_t>();
  }

  std::optional<std::string> missing() const {
    if (read == announced_) return std::nullopt;
    return fmt::format("{} cases where the header announces {}; the file is truncated or was edited", read,
                       announced_);
  }

  std::string op;
  std::uint64_t read = 0;

 private:
  static void require(const Json& header, const char* key, int oldest, int newest) {
    const Json& value = header.at(key);
    const double version = value.is_number() ? value.get<double>() : 0;
    if (version == std::floor(version) && version >= oldest && version <= newest) return;
    throw std::invalid_argument(
        fmt::format("{} is {}; this program knows {} to {}", key, shown(value), oldest, newest));
  }

  std::uint64_t announced_ = 0;
};

}  // namespace

void read_vectors(std::istream& in, const std::string& name, const VectorsVisitor& visitor) {
  std::optional<Section> section;
  std::string line;
  LineRead read;
  Place place{name, 0};
  const auto close_section = [&] {
    if (!section) return;
    if (const std::optional<std::string> problem = section->missing()) visitor.problem(*problem, place);
  };
  while (read_line(in, line, longest_line, read)) {
    ++place.line;
    if (read.too_long) {
      visitor.problem(fmt::format("the line is longer than {} bytes; no case is", longest_line), place);
      continue;
    }
    try {
      const Json json = parse_plain_json(line, name, {}, place.line);
      if (!json.is_object()) throw std::invalid_argument("is no object; a line is a header or a case");
      if (json.contains("schema")) {
        close_section();
        section.emplace(json);
        continue;
      }
      if (!section) throw std::invalid_argument("a case before any header line");
      ++section->read;
      visitor.known_case(section->op, json, place);
    } catch (const InputError& error) {
      visitor.problem(first_problem(error), place);
    } catch (const nlohmann::json::exception& error) {
      visitor.problem(printable(error.what(), longest_reason), place);
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
