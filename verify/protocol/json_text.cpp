#include "verify/protocol/json_text.hpp"

#include <nlohmann/json.hpp>

#include "reference/text/hexfloat.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::protocol {

std::string quoted_number(double x) {
  return '"' + to_hex(x) + '"';
}

std::string vector_text(const std::vector<double>& components) {
  std::string text;
  for (const double x : components) text.append(text.empty() ? "[" : ",").append(quoted_number(x));
  return text + "]";
}

std::string vector_text(const certified::EnclosedVector& components) {
  std::vector<double> nearest;
  for (const certified::Enclosure& x : components) nearest.push_back(x.nearest);
  return vector_text(nearest);
}

std::string quoted(std::string_view text) {
  return tps::json_text(nlohmann::ordered_json(text));
}

}  // namespace tps::protocol
