#include <fmt/format.h>

#include "reference/text/plain_json.hpp"
#include "verify/cost/levels.hpp"

namespace tps::cost {
namespace {

/// The value at a pointer, empty where it is absent.
std::string at(const Json& value, const char* pointer) {
  const Json::json_pointer place(pointer);
  return value.contains(place) ? json_text(value.at(place)) : "";
}

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

}  // namespace

std::string report_csv(const Json& study) {
  if (!study.contains("strata")) return levels_csv(study);
  std::string text = "stratum,variant";
  for (const char* column : kColumns) text += "," + column_name(column);
  text += "\n";
  for (const Json& stratum : study.at("strata")) {
    for (const Json& cell : stratum.at("cells")) {
      text +=
          fmt::format("{},{}", stratum.at("name").get<std::string>(), cell.at("variant").get<std::string>());
      for (const char* column : kColumns) text += "," + at(cell, column);
      text += "\n";
    }
  }
  return text;
}

}  // namespace tps::cost
