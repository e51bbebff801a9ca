#include "properties/implementations/read_reply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties {
namespace {

constexpr std::size_t kShown = 120;

Answer garbage(std::string_view line, std::string_view why) {
  return {Answer::Status::failed, {}, fmt::format("garbage: {}: {}", why, printable(line, kShown))};
}

/// Words for what JSON has no numbers for and many writers of JSON write all the same: NaN, Infinity. What is
/// said is an answer, if a wrong one, and no breach of the protocol.
std::string with_words_for_no_numbers(std::string_view line) {
  std::string text;
  bool in_string = false;
  while (!line.empty()) {
    std::size_t length = 1;
    if (in_string && line[0] == '\\') {
      length = 2;
    } else if (line[0] == '"') {
      in_string = !in_string;
    } else if (!in_string) {
      for (const std::string_view word : {"-Infinity", "Infinity", "-NaN", "NaN"}) {
        if (!line.starts_with(word)) continue;
        text += word.ends_with("NaN") ? "\"nan\"" : word[0] == '-' ? "\"-inf\"" : "\"inf\"";
        line.remove_prefix(word.size());
        length = 0;
        break;
      }
    }
    text += line.substr(0, length);
    line.remove_prefix(std::min(length, line.size()));
  }
  return text;
}

/// Throws InputError.
Json document_of(std::string_view line) {
  try {
    return parse_plain_json(line, "reply");
  } catch (const InputError&) {
    const std::string other = with_words_for_no_numbers(line);
    if (other == line) throw;
    return parse_plain_json(other, "reply");
  }
}

}  // namespace

std::string words(const Json& value, std::size_t longest) {
  return value.is_string() ? printable(value.get_ref<const std::string&>(), longest) : tps::shown(value);
}

std::string request_line(std::uint64_t seq, const Question& question) {
  return json_text(Json{{"seq", seq}, {"op", operations::name(question.op)}, {"in", question.in}});
}

Answer read_reply(std::string_view line, std::uint64_t seq) {
  Json reply;
  try {
    reply = document_of(line);
  } catch (const InputError& error) {
    const std::string problem = first_problem(error);
    return garbage(line, problem.find("not JSON") != std::string::npos ? "not JSON" : problem);
  }
  if (!reply.is_object() || !reply.contains("seq")) return garbage(line, "no object with seq");
  if (reply["seq"] != seq)
    return {Answer::Status::failed,
            {},
            fmt::format("seq {} was asked, {} answered", seq, tps::shown(reply["seq"]))};
  const auto reason = [&](const char* key) {
    const auto message = reply.find("message");
    const std::string kind = words(reply[key], kShown);
    return message != reply.end() && message->is_string() ? kind + ": " + words(*message, kShown) : kind;
  };
  if (reply.contains("out")) return {Answer::Status::answered, std::move(reply["out"])};
  if (reply.contains("skip")) return {Answer::Status::skipped, {}, reason("skip")};
  if (reply.contains("error")) return {Answer::Status::refused, {}, reason("error")};
  return garbage(line, "no out, skip or error");
}

}  // namespace tps::properties
