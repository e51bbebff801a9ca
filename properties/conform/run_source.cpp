#include "properties/conform/run_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "properties/conform/random_scene.hpp"
#include "properties/implementations/child_process.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/scratch_file.hpp"

namespace tps::properties::conform {
namespace {

using Clock = std::chrono::steady_clock;
using Status = ChildProcess::Line::Status;

/// A trace of a hundred events takes less than a tenth of it.
constexpr std::size_t kLongestTrace = std::size_t{1} << 24;
constexpr int kRefuses = 3, kStalls = 6;

Run failed(std::string problem, std::string trace = {}) {
  return {Run::Kind::failed, std::move(trace), std::move(problem)};
}

Run endless(std::string problem, std::string trace) {
  return {Run::Kind::endless, std::move(trace), std::move(problem)};
}

Run run(const std::vector<std::string>& words, std::chrono::milliseconds timeout) {
  ChildProcess process(executing(words));
  const Clock::time_point deadline = Clock::now() + timeout;
  std::string trace;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    const ChildProcess::Line line = process.read_line(std::max(left, std::chrono::milliseconds(1)));
    switch (line.status) {
      case Status::line:
        trace += line.text + "\n";
        if (trace.size() > kLongestTrace)
          return endless(fmt::format("floods: more than {} bytes of trace", kLongestTrace), std::move(trace));
        break;
      case Status::late:
        return endless(fmt::format("hung: no end within {} ms{}", timeout.count(), line.text),
                       std::move(trace));
      case Status::too_long:
        return failed("garbage: a line without an end: " + line.text);
      case Status::closed:
        return failed("closed its output and went on" + line.text);
      case Status::ended:
        if (line.code == kRefuses && trace.empty() && line.rest.empty())
          return {Run::Kind::refused, {}, line.text};
        trace += line.rest;
        if (line.code != 0 && line.code != kStalls) return failed(line.text, std::move(trace));
        return {Run::Kind::traced, std::move(trace), {}};
    }
  }
}

Run traced(const Json& out) {
  const Json lines = out.is_object() ? out.value("trace", Json()) : Json();
  Run found;
  if (!lines.is_array()) {
    return {
        Run::Kind::no_trace,
        {},
        "out is " + tps::shown(out) + R"(; it is {"trace":[line, …]}, each line of the trace as an object)"};
  }
  for (const Json& line : lines) found.trace += json_text(line) + "\n";
  return found;
}

}  // namespace

RunSource command_runs(const std::vector<std::string>& words, std::chrono::milliseconds timeout) {
  const std::string command = fmt::format("{}", fmt::join(words, " "));
  return {command,
          [words, timeout](const Scene& scene) {
            const ScratchFile file(text_of_random(scene));
            std::vector<std::string> whole = words;
            whole.push_back(file.path());
            return run(whole, timeout);
          },
          [command](const Scene&) { return command + " scene.json | tps check --scene scene.json -"; }};
}

RunSource operation_runs(Implementation& subject, std::function<std::string(const Question&)> command_of) {
  const auto question = [](const Scene& scene) {
    return Question{Op::simulate,
                    {{"scene", Json::parse(text_of_random(scene, SceneStyle::compact))},
                     {"max_events", kMostEventsOfARun}}};
  };
  return {subject.name(),
          [&subject, question](const Scene& scene) {
            Answer answer = subject.ask(question(scene));
            if (answer.status == Answer::Status::answered) return traced(answer.out);
            const bool refuses = answer.status != Answer::Status::failed;
            return Run{refuses ? Run::Kind::refused : Run::Kind::failed, {}, std::move(answer.reason)};
          },
          [question, command_of = std::move(command_of)](const Scene& scene) {
            return command_of(question(scene));
          },
          kMostEventsOfARun};
}

}  // namespace tps::properties::conform
