#include "properties/conform/known_question.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "properties/conform/made_ahead.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/number_text.hpp"
#include "verify/vectors/generate.hpp"

namespace tps::properties::conform {
namespace {

/// Numbers beyond the format's range, which nothing rounds to.
struct NotHeld {};

Json rounded(const Json& value, const Format& format) {
  if (value.is_structured()) {
    Json copy = value;
    for (Json& each : copy) each = rounded(each, format);
    return copy;
  }
  if (!value.is_string()) return value;
  const HexFloat number = parse_hex_float(value.get_ref<const std::string&>());
  if (number.verdict != HexFloat::Verdict::exact) return value;  // a word, or "inf"
  if (number.value == 0) return value;
  // Subnormals of the format have fewer bits; a question that needs them is left out, too.
  const int exponent = std::ilogb(number.value);
  if (exponent >= format.max_exponent || exponent < 1 - format.max_exponent) throw NotHeld{};
  return write_hex_float(format.rounded(number.value));
}

/// Whether the format has room for every end of every enclosure.
bool holds(const Json& value, const Format& format) {
  if (value.is_structured())
    return std::all_of(value.begin(), value.end(), [&](const Json& each) { return holds(each, format); });
  if (!value.is_string()) return true;
  const HexFloat number = parse_hex_float(value.get_ref<const std::string&>());
  if (number.verdict != HexFloat::Verdict::exact || number.value == 0) return value != "inf";
  const int exponent = std::ilogb(number.value);
  return exponent < format.max_exponent && exponent >= 1 - format.max_exponent;
}

/// The case in numbers of the format; nothing where there is none.
std::optional<Json> in_format(const std::string& op, Json known, const Format& format) {
  if (format.bits >= 53) return known;
  if (op == "next_event") return std::nullopt;
  try {
    const Json in = rounded(known.at("in"), format);
    const Json accept = known.at("accept"), id = known.at("id"), tags = known.at("tags");
    known = vectors::known_answer(op, in);
    for (const char* key : {"t", "out"}) {
      if (known.contains(key) && !holds(known.at(key), format)) return std::nullopt;
    }
    known["in"] = in;
    known["accept"] = accept;
    known["id"] = id;
    known["tags"] = tags;
    return known;
  } catch (const NotHeld&) {
  } catch (const InputError&) {
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

bool has_outer_collision(const Json& in) {
  const auto collisions = in.find("collisions");
  return collisions != in.end() && std::any_of(collisions->begin(), collisions->end(), [](const Json& c) {
           return c.value("limit", "inner") == "outer";
         });
}

Stratum made(const vectors::Stratum& family, const Selection& selection, const Format& format) {
  Stratum stratum{family.op, family.name, family.why, {}};
  const vectors::Extent extent = vectors::extent_of(family, selection.level, 0);
  for (std::uint64_t n = extent.first; n < extent.first + extent.count; ++n) {
    const NoForkMeanwhile here;
    auto known = in_format(family.op, vectors::case_object(family, vectors::kCommittedSeed, n), format);
    if (!known || (!selection.outer_groups && has_outer_collision(known->at("in")))) continue;
    stratum.cases.push_back(
        {known->at("id").get<std::string>(), family.name, {family.op, known->at("in")}, std::move(*known)});
  }
  return stratum;
}

}  // namespace

void for_known_questions(const Selection& selection, const Format& format,
                         const std::function<bool(Stratum)>& visit) {
  std::vector<const vectors::Stratum*> wanted;
  for (const vectors::Stratum& family : vectors::strata()) {
    if (selection.wants_op(family.op) && selection.wants_stratum(family.op + "." + family.name))
      wanted.push_back(&family);
  }
  for_each_made_ahead<Stratum>(
      wanted.size(), [&](std::size_t n) { return made(*wanted[n], selection, format); },
      [&](Stratum stratum) { return stratum.cases.empty() || visit(std::move(stratum)); });
}

}  // namespace tps::properties::conform
