#include "properties/conform/grade.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "properties/classify.hpp"
#include "properties/conform/effect_margins.hpp"
#include "properties/conform/response_margin.hpp"
#include "properties/conform/timing_margin.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/vectors/check_answers.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::properties::conform {
namespace {

constexpr const char* kOutOfRange =
    "products of the question's numbers leave the range; scale by powers of two first";

const char* what_is_lost(const Question& question) {
  return question.op == Op::drag_time ? "as 1 − γs, rounded, does; log1p keeps these digits"
                                      : "as the printed b² − 4ac does; the stable formula keeps these digits";
}

bool is_timing(const KnownQuestion& known) {
  return known.answer.contains("verdict");
}

/// The narrowest margin within which an answer to a timing operation is right.
Margin margin_of(const Question& question, const TimeAnswer& answer, int bits) {
  if (question.op == Op::drag_time) return margin_of_drag(question.in, answer, bits);
  const auto kind = operations::timing_kind(question.op);
  const exact::TimingQuery query = vectors::read_timing_input(kind.value(), question.in);
  return kind == exact::Kind::plane ? margin_of_plane(query, answer, bits) : margin_of(query, answer, bits);
}

exact::TimingQuery half_of(const Json& order, const char* key) {
  Json in = order.at(key);
  const bool block = in.at("kind") == "block";
  in.erase("kind");
  return vectors::read_timing_input(block ? exact::Kind::block : exact::Kind::tether, in);
}

TimeAnswer time_answer(const Json& out) {
  TimeAnswer answer;
  if (const auto verdict = out.find("verdict"); verdict != out.end())
    answer.verdict = verdict->get<std::string>();
  if (const auto t = out.find("t"); t != out.end() && !t->is_null()) {
    const auto numbers = numbers_of(*t);
    answer.t = numbers && numbers->size() == 1 ? (*numbers)[0] : NAN;
  }
  return answer;
}

struct Word {
  std::string_view name;
  bool occurs;  ///< it has a time
};

/// The verdicts of an operation (docs/protocol.md).
std::vector<Word> words_of(Op op) {
  if (op == Op::drag_time) return {{"reached", true}, {"never", false}};
  std::vector<Word> words;
  for (const TimingVerdict verdict : verdicts_of(operations::timing_kind(op).value()))
    words.push_back({name(verdict), occurs(verdict)});
  return words;
}

/// What an answer to a timing operation says that has no meaning, whatever the question was.
struct Meaningless {
  std::string why;
  bool is_of_range = false;  ///< a time that JSON cannot hold may have become null
};

std::optional<Meaningless> says_nothing(const Question& question, const Json& out) {
  const auto verdict = out.find("verdict");
  if (verdict == out.end()) {
    if (out.contains("t")) return std::nullopt;
    return Meaningless{vectors::kSaysNothing};
  }
  const std::vector<Word> words = words_of(question.op);
  const auto word =
      std::find_if(words.begin(), words.end(), [&](const Word& w) { return *verdict == w.name; });
  if (word == words.end()) {
    std::vector<std::string_view> names;
    for (const Word& each : words) names.push_back(each.name);
    return Meaningless{fmt::format("verdict is {}; the verdicts of {} are {}", tps::shown(*verdict),
                                   operations::name(question.op), fmt::join(names, ", "))};
  }
  const Json t = out.value("t", Json());
  if (word->occurs == !t.is_null()) return std::nullopt;
  return Meaningless{fmt::format("verdict is \"{}\", which has {}, and t is {}", word->name,
                                 word->occurs ? "a time" : "no time", tps::shown(t)),
                     word->occurs};
}

Grade with(Class which, const Comparison& c, const std::string& reason = {}) {
  return {which, reason.empty() ? c.problem : c.problem + ": " + reason, c.units, c.cond};
}

const char* right_by_name(const TimeAnswer& answer) {
  return answer.t ? "its time is right" : "that nothing happens is right";
}

/// Of an answer to a timing query that is not right in K(k).
Grade graded_time(const Question& question, const Json& out, const Comparison& c, const Format& format) {
  TimeAnswer answer = time_answer(out);
  switch (margin_of(question, answer, format.bits)) {
    case Margin::stable:
      if (c.words) return with(Class::rounding, c);
      // The same happens, by the names of two verdicts that rounding cannot tell apart.
      if (c.occurs && c.numbers && c.within) return with(Class::other_reading, c, right_by_name(answer));
      return with(Class::beyond, c, "no evaluation in this precision can tell");
    case Margin::printed:
      return with(Class::worse, c, what_is_lost(question));
    case Margin::none:
      break;
  }
  if (answer.verdict) {
    answer.verdict.reset();
    if (out.contains("t") && margin_of(question, answer, format.bits) == Margin::stable)
      return with(Class::other_reading, c, right_by_name(answer));
  }
  return with(Class::wrong, c);
}

Grade graded_order(const Question& question, const Json& out, const Comparison& c, const Format& format) {
  const Json order = out.value("order", Json());
  switch (margin_of_order(half_of(question.in, "first"), half_of(question.in, "second"),
                          order.is_string() ? order.get<std::string>() : "", format.bits)) {
    case Margin::stable:
      return with(Class::beyond, c, "the times are too near to tell in this precision");
    case Margin::printed:
      return with(Class::worse, c, what_is_lost(question));
    case Margin::none:
      break;
  }
  return with(Class::wrong, c);
}

/// Whether the reference in the same numbers meets a response.
bool meets(Implementation& stable, const KnownQuestion& known, const Format& format, double k) {
  try {
    const Answer answer = stable.ask(known.question);
    if (answer.status == Answer::Status::skipped) return true;  // it has no say
    if (answer.status != Answer::Status::answered) return false;
    for (const Expected& expected : expected_of(known)) {
      const Comparison c = compare(expected, known.question, answer.out, format, k);
      if (c.words && c.within) return true;
    }
  } catch (const std::exception&) {
    return true;
  }
  return false;
}

/// Whether a tether's answer is that of the equation which it chose, by its impulse.
bool is_of_its_kind(const KnownQuestion& known, const Json& out, const Format& format) {
  const bool retracts = out.value("kind", Json()) == "retract";
  Json in = known.question.in;
  if (retracts) {
    in["c"] = in.at("c_retract");
    in.erase("c_revolve");
    in.erase("theta_revolve_deg");
  }
  in.erase("c_retract");
  const Question question{retracts ? Op::collision_impulse : Op::revolution_impulse, in};
  try {
    const Json answer = vectors::known_answer(question.op, in);
    const Expected expected = expected_of({{}, {}, question, answer}).front();
    const Comparison c = compare(expected, question, out, format, accepted_factor(known.answer.at("accept")));
    return c.within;
  } catch (const std::exception&) {
    return false;
  }
}

Grade graded_response(const KnownQuestion& known, const Json& out, const Comparison& c, const Format& format,
                      Implementation& stable, double k) {
  if (known.question.op == Op::tether_response && kind_is_open(known.question, format.bits) &&
      is_of_its_kind(known, out, format))
    return with(Class::beyond, c, "rounding decides between retraction and revolution");
  if (known.question.op == Op::rough_impulse && !c.words && c.numbers && c.within &&
      friction_is_open(known.question, format.bits))
    return with(Class::beyond, c, "rounding decides whether the surfaces hold");
  if (c.words && c.numbers && !leaves_range(known.question, format) && within_bounds(known, out, format.bits))
    return with(Class::rounding, c);
  if (!meets(stable, known, format, k))
    return with(Class::beyond, c, "the reference in this precision misses it, too");
  return with(Class::wrong, c);
}

Grade graded(const KnownQuestion& known, const Json& out, const Format& format, Implementation& stable) {
  if (is_timing(known)) {
    if (auto found = says_nothing(known.question, out)) {
      const bool is_lost = found->is_of_range && leaves_range(known.question, format);
      return {is_lost ? Class::worse : Class::wrong,
              is_lost ? found->why + ": " + kOutOfRange : std::move(found->why)};
    }
  }
  const double k = accepted_factor(known.answer.at("accept"));
  Comparison best;
  bool first = true;
  for (const Expected& expected : expected_of(known)) {
    Comparison c = compare(expected, known.question, out, format, k);
    if (first || (c.words && c.within && !(best.words && best.within))) best = std::move(c);
    first = false;
  }
  if (best.words && best.nearest) return with(Class::right, best);
  if (best.words && best.within) {
    // K(k) knows the coefficients of the quadratic; the landing knows the formula, too.
    const bool is_worse =
        is_timing(known) && margin_of(known.question, time_answer(out), format.bits) == Margin::printed;
    return is_worse ? with(Class::worse, best, what_is_lost(known.question)) : with(Class::rounding, best);
  }
  Grade found = is_timing(known)                 ? graded_time(known.question, out, best, format)
                : known.question.op == Op::order ? graded_order(known.question, out, best, format)
                                                 : graded_response(known, out, best, format, stable, k);
  const bool is_lost = found.which == Class::wrong || found.which == Class::other_reading;
  if (is_lost && leaves_range(known.question, format)) return with(Class::worse, best, kOutOfRange);
  return found;
}

/// Below this a square vanishes, so that a component counts, however large its vector is.
bool vanishes(double x, const Format& format) {
  return x != 0 && std::ilogb(x) < -format.max_exponent / 2;
}

/// The size of every vector and scalar of a document, and of components that vanish.
void sizes(const Json& value, const Format& format, std::vector<double>& found) {
  if (value.is_object()) {
    for (const Json& each : value) sizes(each, format, found);
    return;
  }
  if (value.is_array()) {
    double largest = 0;
    for (const Json& each : value) {
      if (each.is_structured()) {
        sizes(each, format, found);
      } else if (const auto x = numbers_of(each); x && x->size() == 1) {
        if (vanishes((*x)[0], format)) found.push_back((*x)[0]);
        largest = std::max(largest, std::fabs((*x)[0]));
      }
    }
    found.push_back(largest);
  } else if (value.is_string()) {
    if (const auto x = numbers_of(value)) found.push_back(std::fabs(x->at(0)));
  }
}

}  // namespace

bool leaves_range(const Question& question, const Format& format) {
  std::vector<double> found;
  sizes(question.in, format, found);
  const int most = format.max_exponent / 4 - 2;  // a sum of three squares has two bits more
  return std::any_of(found.begin(), found.end(),
                     [&](double x) { return x != 0 && std::isfinite(x) && std::abs(std::ilogb(x)) > most; });
}

Grade grade(const KnownQuestion& known, const Answer& answer, const Format& format, Implementation& stable) {
  if (answer.status != Answer::Status::answered) {
    if (leaves_range(known.question, format))
      return {Class::worse, fmt::format("refused ({}): {}", answer.reason, kOutOfRange)};
    return {Class::refused, answer.reason};
  }
  if (!answer.out.is_object())
    return {Class::wrong,
            "out is " + printable(json_text(answer.out), kShownOfText) + "; it must be an object"};
  return graded(known, answer.out, format, stable);
}

}  // namespace tps::properties::conform
