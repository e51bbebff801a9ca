#include "properties/implementations/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "properties/implementations/child_process.hpp"
#include "properties/implementations/read_reply.hpp"
#include "properties/implementations/serve_library.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties {
namespace {

using Status = ChildProcess::Line::Status;

/// An interpreter may need longer to start than to reply.
constexpr std::chrono::milliseconds kTimeToStart{10'000};

std::string failure(const ChildProcess::Line& line, const char* what, std::chrono::milliseconds limit) {
  if (line.status == Status::late)
    return fmt::format("hung: no {} within {} ms{}", what, limit.count(), line.text);
  if (line.status == Status::too_long) return "garbage: a line without an end: " + line.text;
  return line.text;
}

/// These cost time each.
bool waits_in_vain(const ChildProcess::Line& line) {
  return line.status == Status::late || line.status == Status::closed;
}

class Program final : public Implementation {
 public:
  Program(std::string name, std::function<int()> body, ProgramOptions options)
      : name_(std::move(name)), body_(std::move(body)), options_(options) {
    if (const std::string problem = start(); !problem.empty()) throw ProgramError(name_ + ": " + problem);
  }

  std::string name() const override { return name_; }
  Format format() const override { return Format::of_bits(bits_); }
  std::string given_up() const override { return given_up_; }
  std::optional<std::vector<std::string>> offered() const override { return offered_; }
  std::vector<std::string> features() const override { return features_; }
  bool takes_outer_groups() const override { return takes_outer_groups_; }

  Answer ask(const Question& question) override {
    if (!given_up_.empty()) return {Answer::Status::failed, {}, given_up_};
    return noted(reply_to(question));
  }

  /// A window of requests is on its way at a time. Where a reply does not come, its requests are sent again
  /// one by one: a program that buffers its replies takes answered ones with it when it ends.
  std::vector<Answer> ask_all(const std::vector<Question>& questions) override {
    std::vector<Answer> answers;
    answers.reserve(questions.size());
    while (answers.size() < questions.size() && given_up_.empty()) {
      const std::size_t first = answers.size(), end = std::min(first + kWindow, questions.size());
      if (!ask_ahead(questions, end, answers)) {
        while (answers.size() < end) answers.push_back(ask(questions[answers.size()]));
      }
    }
    while (answers.size() < questions.size()) answers.push_back(ask(questions[answers.size()]));
    return answers;
  }

 private:
  /// Appends the answers up to `end`. @return whether all came; else the program is gone.
  bool ask_ahead(const std::vector<Question>& questions, std::size_t end, std::vector<Answer>& answers) {
    if (child_ == nullptr) return false;
    const std::uint64_t before = seq_ - answers.size();
    for (std::size_t n = answers.size(); n < end; ++n) child_->write_line(request_line(++seq_, questions[n]));
    while (answers.size() < end) {
      const ChildProcess::Line line = child_->read_line(options_.timeout);
      Answer answer = line.status == Status::line ? read_reply(line.text, before + answers.size() + 1)
                                                  : Answer{Answer::Status::failed, {}, {}};
      if (answer.status == Answer::Status::failed) {
        child_.reset();
        return false;
      }
      failures_in_a_row_ = 0;
      answers.push_back(std::move(answer));
    }
    return true;
  }

  /// Counts failures, and gives up after too many.
  Answer noted(Answer answer) {
    if (answer.status != Answer::Status::failed) {
      failures_in_a_row_ = 0;
      return answer;
    }
    child_.reset();
    ++failures_in_a_row_;
    if (hangs_ >= kMostHangs) given_up_ = fmt::format("given up after {} hangs", hangs_);
    if (failures_in_a_row_ >= kMostFailuresInARow)
      given_up_ = fmt::format("given up after {} failures in a row", failures_in_a_row_);
    return answer;
  }

  Answer reply_to(const Question& question) {
    if (child_ == nullptr) {
      if (const std::string problem = start(); !problem.empty())
        return {Answer::Status::failed, {}, "cannot be started again: " + problem};
    }
    ++seq_;
    child_->write_line(request_line(seq_, question));
    const ChildProcess::Line line = child_->read_line(options_.timeout);
    hangs_ += waits_in_vain(line) ? 1 : 0;
    if (line.status == Status::line) return read_reply(line.text, seq_);
    return {Answer::Status::failed, {}, failure(line, "reply", options_.timeout)};
  }

  /// @return what is wrong; empty if it answers.
  std::string start() {
    const std::chrono::milliseconds limit = std::max(options_.timeout, kTimeToStart);
    try {
      child_ = std::make_unique<ChildProcess>(body_);
    } catch (const std::system_error& error) {
      return error.what();
    }
    child_->write_line(R"({"hello":1})");
    const ChildProcess::Line line = child_->read_line(limit);
    hangs_ += waits_in_vain(line) ? 1 : 0;
    const std::string problem =
        line.status == Status::line ? read_hello(line.text) : failure(line, "answer to hello", limit);
    if (!problem.empty()) child_.reset();
    return problem;
  }

  std::string read_hello(const std::string& line) {
    Json hello;
    try {
      hello = parse_plain_json(line, "reply");
    } catch (const InputError&) {
      // Said below, as of any other line that is no answer.
    }
    if (hello.is_object() && hello.contains("error"))
      return "hello is answered with an error: " + words(hello["error"], 400);
    if (!hello.is_object() || !hello.value("name", Json()).is_string())
      return "the answer to hello has no name: " + printable(line, 200);
    if (auto problem = read_offer(hello)) return std::move(*problem);
    if (options_.bits) {
      bits_ = *options_.bits;
    } else if (const auto bits = hello.find("bits"); bits != hello.end()) {
      const bool known =
          bits->is_number_integer() && bits->get<double>() >= kLeastBits && bits->get<double>() <= kMostBits;
      if (!known) {
        return fmt::format("the answer to hello has bits = {}; allowed are integers from {} to {}",
                           tps::shown(*bits), kLeastBits, kMostBits);
      }
      bits_ = bits->get<int>();
    }
    return {};
  }

  /// @return what is wrong with it
  std::optional<std::string> read_offer(const Json& hello) {
    const Json group = hello.value("group", Json("outer"));
    if (group != "inner" && group != "outer")
      return "the answer to hello has group = " + tps::shown(group) + R"(; allowed are "inner" and "outer")";
    takes_outer_groups_ = group == "outer";
    std::optional<std::vector<std::string>> features;
    for (const auto& [key, words] : {std::pair{"features", &features}, std::pair{"ops", &offered_}}) {
      const auto list = hello.find(key);
      if (list == hello.end()) continue;
      *words = words_in(*list);
      if (!*words) {
        return fmt::format("the answer to hello has {} = {}; allowed is a list of words, [\"…\", …]", key,
                           tps::shown(*list));
      }
    }
    features_ = std::move(features).value_or(std::vector<std::string>());
    return std::nullopt;
  }

  static std::optional<std::vector<std::string>> words_in(const Json& list) {
    if (!list.is_array()) return std::nullopt;
    std::vector<std::string> words;
    for (const Json& word : list) {
      if (!word.is_string()) return std::nullopt;
      words.push_back(word.get<std::string>());
    }
    return words;
  }

  static constexpr std::size_t kWindow = 256;
  static constexpr int kLeastBits = 8, kMostBits = 400;

  std::string name_;
  std::function<int()> body_;
  ProgramOptions options_;
  int bits_ = 53;
  std::optional<std::vector<std::string>> offered_;
  std::vector<std::string> features_;
  bool takes_outer_groups_ = true;
  std::uint64_t seq_ = 0;
  int hangs_ = 0, failures_in_a_row_ = 0;
  std::string given_up_;
  std::unique_ptr<ChildProcess> child_;
};

}  // namespace

std::unique_ptr<Implementation> command(const std::vector<std::string>& words,
                                        const ProgramOptions& options) {
  return std::make_unique<Program>(fmt::format("{}", fmt::join(words, " ")), executing(words), options);
}

std::unique_ptr<Implementation> shared_library(const std::string& path, const ProgramOptions& options) {
  const std::string name = std::filesystem::path(path).filename().string();
  return std::make_unique<Program>(
      name, [path] { return serve_library(path); }, options);
}

}  // namespace tps::properties
