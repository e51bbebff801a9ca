#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cost/levels.hpp"

namespace tps::cost {
namespace {

constexpr const char* kColumns[] = {"/asked",
                                    "/missed",
                                    "/invented",
                                    "/moved",
                                    "/wrong_per_million/value",
                                    "/wrong_per_million/low",
                                    "/wrong_per_million/high",
                                    "/log2_error/compared",
                                    "/log2_error/p50",
                                    "/log2_error/p99",
                                    "/log2_error/max",
                                    "/ns/throughput/min",
                                    "/ns/throughput/q1",
                                    "/ns/throughput/median",
                                    "/ns/throughput/q3",
                                    "/ns/latency/min",
                                    "/ns/latency/median",
                                    "/ratio/value",
                                    "/ratio/low",
                                    "/ratio/high",
                                    "/paths/0/questions",
                                    "/paths/0/ns",
                                    "/paths/1/questions",
                                    "/paths/1/ns",
                                    "/paths/2/questions",
                                    "/paths/2/ns"};

/// "/ns/throughput/min" as a name of a column: ns_throughput_min.
std::string column_name(std::string pointer) {
  for (char& c : pointer) {
    if (c == '/') c = '_';
  }
  return pointer.substr(1);
}

/// A text as a field of CSV (RFC 4180).
std::string field(const std::string& text) {
  const std::string safe = printable(text);
  if (safe.find_first_of(",\"") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// A row for each variant and stratum.
std::vector<Json> query_rows(const Json& study) {
  std::vector<Json> rows;
  for (const Json& stratum : study.at("strata")) {
    for (const Json& cell : stratum.at("cells")) {
      Json row{{"stratum", stratum.at("name")}, {"variant", cell.at("variant")}};
      for (const char* column : kColumns) {
        const Json::json_pointer place(column);
        row[column_name(column)] = cell.contains(place) ? cell.at(place) : Json();
      }
      rows.push_back(row);
    }
  }
  return rows;
}

std::string table(const std::vector<Json>& rows) {
  std::vector<std::string> columns;
  for (const Json& row : rows) {
    for (const auto& [key, value] : row.items()) {
      if (std::find(columns.begin(), columns.end(), key) == columns.end()) columns.push_back(key);
    }
  }
  std::string text = fmt::format("{}\n", fmt::join(columns, ","));
  for (const Json& row : rows) {
    const char* before = "";
    for (const std::string& column : columns) {
      text += before;
      before = ",";
      if (!row.contains(column) || row.at(column).is_null()) continue;
      const Json& value = row.at(column);
      text += value.is_string() ? field(value.get<std::string>()) : json_text(value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::string report_csv(const Json& study) {
  const std::vector<Json> levels = level_rows(study);
  if (!study.contains("strata")) return table(levels);
  std::vector<Json> rows = query_rows(study);
  if (!levels.empty()) {
    for (Json& row : rows) row["level"] = "queries";
  }
  rows.insert(rows.end(), levels.begin(), levels.end());
  return table(rows);
}

}  // namespace tps::cost
