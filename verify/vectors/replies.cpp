#include "verify/vectors/replies.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "reference/text/file_kind.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/line_source.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "reference/text/text_file.hpp"
#include "verify/vectors/read_vectors.hpp"

namespace tps::cli {
namespace {

using vectors::Json;

constexpr std::size_t kLongestReply = std::size_t{1} << 20U;

}  // namespace

bool Replies::names(const Json& known) const {
  return by_case.contains(json_text(known.at("id")));
}

const Json* Replies::find(const Json& known, std::uint64_t seq) const {
  auto reply = by_case.find(json_text(known.at("id")));
  if (reply == by_case.end()) reply = by_case.find(std::to_string(seq));
  return reply == by_case.end() ? nullptr : &reply->second;
}

Replies read_replies(const std::string& path) {
  refuse_other_kinds_of_file(path, "a file of replies", {FileKind::replies});
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& in = path == "-" ? std::cin : file;
  std::error_code unknown;
  if (!in || (path != "-" && std::filesystem::is_directory(path, unknown))) {
    throw InputError({{path, 0, "", "cannot be read; --answers takes one reply a line"}});
  }
  Replies replies;
  std::string line;
  LineRead read;
  for (std::size_t number = 1; read_line(in, line, kLongestReply, read); ++number) {
    if (read.too_long) {
      throw InputError(
          {{path, number, "", fmt::format("is longer than {} bytes; no reply is", kLongestReply)}});
    }
    Json reply = parse_plain_json(line, display_name(path), {}, number);
    const bool named = reply.is_object() && (reply.contains("id") || reply.contains("seq"));
    if (reply.is_object() && reply.contains("name") && !named) {  // the answer to hello
      for (const Json& op : reply.value("ops", Json::array())) {
        if (op.is_string()) replies.offered.insert(op.get<std::string>());
      }
      continue;
    }
    if (!named) {
      throw InputError(
          {{path, number, "", R"(is not a reply; allowed: {"id":…,"out":{…}} or {"seq":n,"out":{…}})"}});
    }
    const std::string key = json_text(reply.contains("id") ? reply["id"] : reply["seq"]);
    if (!replies.by_case.emplace(key, std::move(reply)).second) {
      throw InputError(
          {{path, number, "",
            fmt::format("is a second reply to {}; each question has one", printable(key, 100))}});
    }
  }
  return replies;
}

}  // namespace tps::cli
