#include "verify/protocol/conversation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "reference/process/missing_library.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/version.hpp"
#include "verify/protocol/answer.hpp"

namespace tps::protocol {
namespace {

constexpr std::size_t kMostProblemsShown = 10;
const std::string kSource = "request";

/// Any text as a JSON string; bytes that are not UTF-8 become U+FFFD.
std::string as_json(std::string_view text) {
  return json_text(nlohmann::ordered_json(text));
}

/// Why there is no answer, in a word for programs and a sentence for people.
struct Failure {
  const char* kind;
  std::string message;
};

std::string message_of(const InputError& error) {
  std::string text;
  std::size_t shown = 0;
  for (const InputProblem& problem : error.problems()) {
    if (!text.empty()) text += "; ";
    if (++shown > kMostProblemsShown) {
      return text + fmt::format("and {} more", error.problems().size() - kMostProblemsShown);
    }
    if (!problem.pointer.empty()) text += problem.pointer + ": ";
    text += problem.message;
  }
  return text;
}

Reply failed(const std::string& seq, const Failure& failure) {
  return {
      fmt::format(R"({{"seq":{},"error":"{}","message":{}}})", seq, failure.kind, as_json(failure.message))};
}

Reply hello() {
  std::string operations;
  for (const std::string& name : operation_names())
    operations.append(operations.empty() ? "" : ",").append(as_json(name));
  return {fmt::format(
      R"({{"name":"tps","version":{},"semantics":{},"ops":[{}],"precision":"correctly rounded double, where an answer is not flagged unsettled or simulated"}})",
      as_json(version()), kSemanticsVersion, operations)};
}

/// The text of an integer that every JSON reader holds exactly.
std::optional<std::string> sequence_number(const JsonValue* value) {
  if (value == nullptr || value->number() == nullptr) return std::nullopt;
  const double n = value->number()->value;
  if (!(std::fabs(n) <= 0x1p53) || std::trunc(n) != n || value->number()->rounded_integer)
    return std::nullopt;
  return fmt::format("{:.0f}", n + 0.0);
}

/// What keeps an object from being a request, if anything.
std::optional<Failure> malformed(const JsonValue& request, bool has_seq) {
  static const std::vector<std::string> keys{"seq", "op", "in"};
  if (request.object() == nullptr)
    return Failure{"bad_request",
                   R"(a request is an object: {"seq":n,"op":…,"in":{…}}, {"hello":1} or {"bye":1})"};
  for (const char* alone : {"hello", "bye"}) {
    if (request.find(alone) != nullptr)
      return Failure{"bad_request", fmt::format("{} stands alone in its line: {{\"{}\":1}}", alone, alone)};
  }
  for (const JsonMember& each : *request.object()) {
    if (std::find(keys.begin(), keys.end(), each.key) != keys.end()) continue;
    return Failure{"bad_request", fmt::format("a request has no key {}{} It has seq, op and in", each.key,
                                              did_you_mean(each.key, keys))};
  }
  if (!has_seq) return Failure{"bad_request", "seq must be an integer of at most 2^53"};
  const JsonValue* op = request.find("op");
  if (op == nullptr || op->string() == nullptr)
    return Failure{"bad_request", "op must be the name of an operation"};
  if (request.find("in") == nullptr)
    return Failure{"bad_request", "in, the input of the operation, is missing"};
  return std::nullopt;
}

Reply answered(const std::string& seq, const JsonValue& request) {
  const std::string& op = *request.find("op")->string();
  const operations::Operation* operation = operations::find(op);
  if (operation == nullptr || !operation->is_certified) {
    const std::vector<std::string>& known = operation_names();
    return {fmt::format(R"({{"seq":{},"skip":"unknown_op","message":{}}})", seq,
                        as_json(fmt::format("unknown operation {}{} There are {}", op,
                                            did_you_mean(op, known), fmt::join(known, ", "))))};
  }
  try {
    return {fmt::format(R"({{"seq":{},"out":{}}})", seq,
                        answer_text(operation->op, *request.find("in"), {kSource, "/in"}))};
  } catch (const InputError& error) {
    return failed(seq, {"bad_input", message_of(error)});
  }
}

/// What became of a request that cannot be answered, with the seq that is known by then.
template <typename Answer>
Reply guarded(const std::string& seq, Answer answer) try {
  return answer();
} catch (const InputError& error) {
  return failed(seq, {"bad_json", message_of(error)});
} catch (const std::bad_alloc&) {
  return failed(seq, {"too_large", "not enough memory for this request; give it in smaller parts"});
} catch (const MissingLibrary&) {
  throw;  // no question has an answer then
} catch (const std::exception& error) {
  return failed(seq, {"internal", fmt::format("an error of ours, please report it: {}", error.what())});
}

Reply reply_to_document(const JsonDocument& document) {
  const JsonValue& request = document.root;
  const std::optional<std::string> known_seq = sequence_number(request.find("seq"));
  const std::string seq = known_seq.value_or("null");
  if (!document.problems.empty())
    return failed(seq, {"bad_json", message_of(InputError(document.problems.problems()))});
  if (request.object() != nullptr && request.object()->size() == 1) {
    const JsonMember& only = request.object()->front();
    if (only.key == "bye") return {"", true};
    if (only.key == "hello") {
      const JsonNumber* version = only.value.number();
      if (version != nullptr && version->value == 1) return hello();
      return failed(seq, {"bad_request", "this is version 1 of the protocol; say {\"hello\":1}"});
    }
  }
  if (const std::optional<Failure> failure = malformed(request, known_seq.has_value()))
    return failed(seq, *failure);
  return guarded(seq, [&] { return answered(seq, request); });
}

}  // namespace

Reply reply_to(std::string_view line) {
  return guarded("null", [&] { return reply_to_document(parse_json(line, kSource)); });
}

Reply reply_to_long_line(std::string_view beginning) {
  return failed("null", {"line_too_long", fmt::format("a request has at most {} bytes; this one begins {}",
                                                      kLongestRequest, beginning)});
}

}  // namespace tps::protocol
