#include "properties/implementations/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

#include "properties/implementations/child_process.hpp"
#include "properties/implementations/read_reply.hpp"
#include "properties/implementations/serve_library.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"

namespace tps::properties {
namespace {

using Status = ChildProcess::Line::Status;

/// An interpreter may need longer to start than to reply.
constexpr std::chrono::milliseconds kTimeToStart{10'000};

std::string failure(const ChildProcess::Line& line, const ProgramOptions& options) {
  if (line.status == Status::late) return fmt::format("hung: no reply within {} ms", options.timeout.count());
  if (line.status == Status::too_long) return "garbage: a line without an end: " + line.text;
  return line.text;
}

class Program final : public Implementation {
 public:
  Program(std::string name, std::function<int()> body, ProgramOptions options)
      : name_(std::move(name)), body_(std::move(body)), options_(options) {
    if (const std::string problem = start(); !problem.empty()) throw ProgramError(name_ + ": " + problem);
  }

  std::string name() const override { return name_; }
  Format format() const override { return Format::of_bits(bits_); }

  Answer ask(const Question& question) override {
    if (child_ == nullptr) {
      if (const std::string problem = start(); !problem.empty())
        return {Answer::Status::failed, {}, "cannot be started again: " + problem};
    }
    ++seq_;
    child_->write_line(request_line(seq_, question));  // a child that is gone shows when its reply is read
    const ChildProcess::Line line = child_->read_line(options_.timeout);
    Answer answer = line.status == Status::line ? read_reply(line.text, seq_)
                                                : Answer{Answer::Status::failed, {}, failure(line, options_)};
    if (answer.status == Answer::Status::failed) child_.reset();
    return answer;
  }

 private:
  /// @return what is wrong; empty if it answers.
  std::string start() {
    try {
      child_ = std::make_unique<ChildProcess>(body_);
    } catch (const std::system_error& error) {
      return error.what();
    }
    child_->write_line(R"({"hello":1})");
    const ChildProcess::Line line = child_->read_line(std::max(options_.timeout, kTimeToStart));
    std::string problem;
    if (line.status != Status::line) {
      problem = failure(line, options_);
    } else {
      Json hello;
      try {
        hello = parse_plain_json(line.text, "reply");
      } catch (const InputError&) {
        // Said below, as of any other line that is no answer.
      }
      if (!hello.is_object() || !hello.contains("name")) {
        problem = "the answer to hello has no name: " + printable(line.text, 200);
      } else if (options_.bits) {
        bits_ = *options_.bits;
      } else if (const auto bits = hello.find("bits"); bits != hello.end() && bits->is_number_integer()) {
        bits_ = std::clamp(bits->get<int>(), 8, 400);
      }
    }
    if (!problem.empty()) child_.reset();
    return problem;
  }

  std::string name_;
  std::function<int()> body_;
  ProgramOptions options_;
  int bits_ = 53;
  std::uint64_t seq_ = 0;
  std::unique_ptr<ChildProcess> child_;
};

constexpr int kNotExecuted = 127;  // as shells have it

int execute(const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  return kNotExecuted;
}

}  // namespace

std::unique_ptr<Implementation> command(const std::vector<std::string>& words,
                                        const ProgramOptions& options) {
  return std::make_unique<Program>(
      fmt::format("{}", fmt::join(words, " ")), [words] { return execute(words); }, options);
}

std::unique_ptr<Implementation> shared_library(const std::string& path, const ProgramOptions& options) {
  const std::string name = std::filesystem::path(path).filename().string();
  return std::make_unique<Program>(
      name, [path] { return serve_library(path); }, options);
}

}  // namespace tps::properties
