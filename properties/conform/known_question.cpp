#include "properties/conform/known_question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "properties/conform/made_ahead.hpp"
#include "properties/conform/siblings.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/number_text.hpp"
#include "verify/operations/no_answer.hpp"
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
  return to_hex<double>(format.rounded(number.value));
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

/// The case with another question, in numbers of the format; nothing where that has no answer which the
/// format holds.
std::optional<Json> with_question(Op op, const Json& known, const Json& in, const Format& format) {
  const bool narrow = format.bits < 53;
  if (narrow && op == Op::next_event) return std::nullopt;
  try {
    const Json asked = narrow ? rounded(in, format) : in;
    Json made = vectors::known_answer(op, asked);
    for (const char* key : {"t", "out"}) {
      if (narrow && made.contains(key) && !holds(made.at(key), format)) return std::nullopt;
    }
    made["in"] = asked;
    for (const char* key : {"accept", "id", "tags"}) made[key] = known.at(key);
    return made;
  } catch (const NotHeld&) {
  } catch (const InputError&) {
  } catch (const operations::NoAnswer&) {
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

/// The case in numbers of the format; nothing where there is none.
std::optional<Json> in_format(Op op, Json known, const Format& format) {
  if (format.bits >= 53) return known;
  return with_question(op, known, known.at("in"), format);
}

bool has_outer_collision(const Json& in) {
  const auto collisions = in.find("collisions");
  return collisions != in.end() && std::any_of(collisions->begin(), collisions->end(), [](const Json& c) {
           return c.value("limit", "inner") == "outer";
         });
}

bool can_be_asked(const Json& in, const Selection& selection) {
  return selection.outer_groups || !has_outer_collision(in);
}

KnownQuestion question_of(Op op, const char* stratum, Json known) {
  const std::string id = known.at("id").get<std::string>();
  return {id, stratum, {op, known.at("in")}, std::move(known)};
}

Stratum made(const vectors::Stratum& family, const Selection& selection, const Format& format) {
  Stratum stratum{family.op, family.name, family.why, {}};
  const vectors::Extent extent = vectors::extent_of(family, selection.level, 0);
  for (std::uint64_t n = extent.first; n < extent.first + extent.count; ++n) {
    const NoForkMeanwhile here;
    auto known = in_format(family.op, vectors::case_object(family, vectors::kCommittedSeed, n), format);
    if (known && can_be_asked(known->at("in"), selection))
      stratum.cases.push_back(question_of(family.op, family.name.c_str(), std::move(*known)));
  }
  return stratum;
}

/// Whether a change of the question changes the answer.
bool happens_later(const Json& known) {
  const auto t = known.find("t");
  return t == known.end() || (!t->is_null() && vectors::read_number(t->at(0)) > 0);
}

/// The case, its siblings, and the case again: what was asked in between changes nothing.
void add_with_siblings(Stratum& stratum, const Json& parent, const Format& format) {
  const auto add = [&](Json known, const std::string& what) {
    if (!what.empty()) known["id"] = fmt::format("{}/{}", known.at("id").get<std::string>(), what);
    stratum.cases.push_back(question_of(stratum.op, kSiblings, std::move(known)));
  };
  add(parent, "");
  for (const Sibling& sibling : siblings_of(parent.at("in"))) {
    auto known = with_question(stratum.op, parent, sibling.in, format);
    if (!known) continue;
    add(std::move(*known), sibling.changed);
    stratum.cases.back().is_sibling = true;
  }
  add(parent, "again");
}

/// The first cases of a stratum in which something happens, but not at once.
Stratum with_siblings(const vectors::Stratum& family, const Selection& selection, const Format& format) {
  Stratum stratum{family.op, kSiblings, "one number of a question changed, everything else as it was", {}};
  int parents = selection.level == 1 ? 1 : 4;
  for (std::uint64_t n = 0; parents > 0 && n < static_cast<std::uint64_t>(family.committed); ++n) {
    const NoForkMeanwhile here;
    const auto parent =
        in_format(family.op, vectors::case_object(family, vectors::kCommittedSeed, n), format);
    if (!parent || !happens_later(*parent) || !can_be_asked(parent->at("in"), selection)) continue;
    --parents;
    add_with_siblings(stratum, *parent, format);
  }
  return stratum;
}

}  // namespace

void for_known_questions(const Selection& selection, const Format& format,
                         const std::function<bool(Stratum)>& visit) {
  std::vector<std::function<Stratum()>> wanted;
  std::optional<Op> op;
  for (const vectors::Stratum& family : vectors::strata()) {
    const bool is_first = op != family.op;
    op = family.op;
    if (!selection.wants_op(family.op)) continue;
    if (selection.wants_stratum(family.full_name()))
      wanted.emplace_back([&] { return made(family, selection, format); });
    if (is_first && selection.wants_stratum(siblings_name(family.op)))
      wanted.emplace_back([&] { return with_siblings(family, selection, format); });
  }
  for_each_made_ahead<Stratum>(
      wanted.size(), [&](std::size_t n) { return wanted[n](); },
      [&](Stratum stratum) { return stratum.cases.empty() || visit(std::move(stratum)); });
}

}  // namespace tps::properties::conform
