#include "properties/implementations/read_reply.hpp"

#include <fmt/format.h>

namespace tps::properties {
namespace {

constexpr std::size_t kShown = 120;

Answer garbage(std::string_view line, const char* why) {
  return {Answer::Status::failed, {}, fmt::format("garbage: {}: {}", why, line.substr(0, kShown))};
}

}  // namespace

std::string request_line(std::uint64_t seq, const Question& question) {
  return Json{{"seq", seq}, {"op", question.op}, {"in", question.in}}.dump();
}

Answer read_reply(std::string_view line, std::uint64_t seq) {
  Json reply = Json::parse(line, nullptr, false);
  if (reply.is_discarded()) return garbage(line, "not JSON");
  if (!reply.is_object() || !reply.contains("seq")) return garbage(line, "no object with seq");
  if (reply["seq"] != seq)
    return {
        Answer::Status::failed, {}, fmt::format("seq {} was asked, {} answered", seq, reply["seq"].dump())};
  const auto reason = [&](const char* key) {
    const std::string kind = reply[key].is_string() ? reply[key].get<std::string>() : reply[key].dump();
    const auto message = reply.find("message");
    return message != reply.end() && message->is_string() ? kind + ": " + message->get<std::string>() : kind;
  };
  if (reply.contains("out")) return {Answer::Status::answered, std::move(reply["out"])};
  if (reply.contains("skip")) return {Answer::Status::skipped, {}, reason("skip")};
  if (reply.contains("error")) return {Answer::Status::refused, {}, reason("error")};
  return garbage(line, "no out, skip or error");
}

}  // namespace tps::properties
