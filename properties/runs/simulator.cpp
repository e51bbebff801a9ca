#include "properties/runs/simulator.hpp"

#include <stdexcept>

#include "properties/implementations/child_process.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/scratch_file.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps::properties::runs {
namespace {

class Reference final : public Simulator {
 public:
  Reference(std::string scalar, std::string timing)
      : scalar_(std::move(scalar)), timing_(std::move(timing)) {}
  std::string name() const override { return "tps::reference"; }
  std::string scalar() const override { return scalar_; }
  std::string timing() const override { return timing_; }
  std::vector<std::string> detectors() const override { return {"all-pairs", "cells"}; }

  std::string simulate(const Scene& scene, const Extent& extent) override {
    certified::ExactTiming certifier;
    const ScratchFile trace;
    run_scene(scene, options(extent, certifier, trace.path()));
    return trace.content();
  }

  std::optional<std::string> go_on(const std::string& beginning, const Extent& extent) override {
    certified::ExactTiming certifier;
    const ScratchFile from(beginning);
    const ScratchFile trace;
    resume_run(from.path(), options(extent, certifier, trace.path()));
    return trace.content();
  }

 private:
  RunOptions options(const Extent& extent, certified::ExactTiming& certifier,
                     const std::string& trace) const {
    RunOptions options;
    options.scalar = scalar_kind(scalar_).value();
    options.timing = timing_named(timing_).value();
    options.certifier = &certifier;
    options.max_events = extent.max_events;
    options.state_every = extent.state_every;
    if (!extent.detector.empty()) options.detector = detector_named(extent.detector).value();
    options.trace = trace;
    return options;
  }

  std::string scalar_, timing_;
};

class Command final : public Simulator {
 public:
  Command(std::vector<std::string> words, std::string scalar, std::string timing,
          std::chrono::milliseconds limit)
      : words_(std::move(words)), scalar_(std::move(scalar)), timing_(std::move(timing)), limit_(limit) {}
  std::string name() const override { return joined(words_); }
  std::string scalar() const override { return scalar_; }
  std::string timing() const override { return timing_; }

  std::string simulate(const Scene& scene, const Extent& extent) override {
    const ScratchFile file(write_scene(scene));
    std::vector<std::string> words{file.path(), "--scalar", scalar_, "--timing", timing_};
    if (extent.state_every != 0)
      words.insert(words.end(), {"--state-every", std::to_string(extent.state_every)});
    return traced(words, extent);
  }

  std::optional<std::string> go_on(const std::string& beginning, const Extent& extent) override {
    const ScratchFile file(beginning);
    return traced({"--resume", file.path()}, extent);
  }

 private:
  static std::string joined(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
    return line;
  }

  /// A stalled run has its trace, too (exit code 6).
  std::string traced(const std::vector<std::string>& added, const Extent& extent) const {
    const ScratchFile trace;
    std::vector<std::string> words = words_;
    words.insert(words.end(), added.begin(), added.end());
    words.insert(words.end(), {"-q", "-o", trace.path(), "--max-events", std::to_string(extent.max_events)});
    ChildProcess process(executing(words));
    const ChildProcess::Line end = process.read_to_end(limit_);
    if (end.status == ChildProcess::Line::Status::late) {
      throw std::runtime_error("the command '" + joined(words) + "' hung: it did not end within " +
                               std::to_string(limit_.count()) + " ms" + end.text);
    }
    if (end.code != 0 && end.code != 6)
      throw std::runtime_error("the command '" + joined(words) + "' " + end.text +
                               "; allowed: exit code 0, and 6 for a run that stalled");
    return trace.content();
  }

  std::vector<std::string> words_;
  std::string scalar_, timing_;
  std::chrono::milliseconds limit_;
};

}  // namespace

std::unique_ptr<Simulator> reference_simulator(const std::string& scalar, const std::string& timing) {
  return std::make_unique<Reference>(scalar, timing);
}

std::unique_ptr<Simulator> command_simulator(const std::vector<std::string>& words, const std::string& scalar,
                                             const std::string& timing, std::chrono::milliseconds limit) {
  return std::make_unique<Command>(words, scalar, timing, limit);
}

}  // namespace tps::properties::runs
