#include "properties/implementations/has_answer.hpp"

#include <algorithm>
#include <cmath>

#include "properties/implementations/read_reply.hpp"
#include "reference/text/number_text.hpp"
#include "verify/protocol/conversation.hpp"

namespace tps::properties {
namespace {

/// Every number within it is finite in the format.
bool holds(const Json& value, const Format& format) {
  if (value.is_structured())
    return std::all_of(value.begin(), value.end(), [&](const Json& each) { return holds(each, format); });
  if (!value.is_string()) return true;
  const std::string& text = value.get_ref<const std::string&>();
  if (text == "inf" || text == "-inf") return false;
  const HexFloat number = parse_hex_float(text);
  const bool is_number = number.verdict == HexFloat::Verdict::exact && number.value != 0;
  return !is_number || std::ilogb(number.value) < format.max_exponent;
}

}  // namespace

bool has_answer(const Question& question, const Format& format) {
  if (question.op == Op::distance) return true;
  // At rest to each other a pair collides with nothing (its verdict is static): whoever finds 0/0 there may
  // say so.
  if (question.op == Op::tether_response && question.in.at("v_A") == question.in.at("v_B")) return false;
  const Answer certified = read_reply(protocol::reply_to(request_line(1, question)).text, 1);
  // Pulled along û with c_retract = 0 rounding decides between (4) and (5), and (5) is 0/0 there.
  if (certified.out.is_object() && certified.out.contains("boundary")) return false;
  return certified.status == Answer::Status::answered && holds(certified.out, format);
}

}  // namespace tps::properties
