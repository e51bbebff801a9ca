#include "properties/runs/simulator.hpp"

#include <cstdlib>
#include <stdexcept>

#include "properties/runs/scratch_file.hpp"
#include "reference/run/run.hpp"
#include "reference/scene/write_scene.hpp"
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
    options.trace = trace;
    return options;
  }

  std::string scalar_, timing_;
};

class Command final : public Simulator {
 public:
  Command(std::string command, std::string scalar, std::string timing)
      : command_(std::move(command)), scalar_(std::move(scalar)), timing_(std::move(timing)) {}
  std::string name() const override { return command_; }
  std::string scalar() const override { return scalar_; }
  std::string timing() const override { return timing_; }

  std::string simulate(const Scene& scene, const Extent& extent) override {
    const ScratchFile file(write_scene(scene));
    std::string line = command_ + " '" + file.path() + "' --scalar " + scalar_ + " --timing " + timing_;
    if (extent.state_every != 0) line += " --state-every " + std::to_string(extent.state_every);
    return traced(line, extent);
  }

  std::optional<std::string> go_on(const std::string& beginning, const Extent& extent) override {
    const ScratchFile file(beginning);
    return traced(command_ + " --resume '" + file.path() + "'", extent);
  }

 private:
  /// A stalled run has its trace, too (exit code 6).
  static std::string traced(const std::string& line, const Extent& extent) {
    const ScratchFile trace;
    const std::string whole = line + " -q -o '" + trace.path() + "' --max-events " +
                              std::to_string(extent.max_events) + " > /dev/null";
    const int status = std::system(whole.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (code != 0 && code != 6)
      throw std::runtime_error("the command '" + whole + "' ended with exit code " + std::to_string(code) +
                               "; allowed: 0, and 6 for a run that stalled");
    return trace.content();
  }

  std::string command_, scalar_, timing_;
};

}  // namespace

std::unique_ptr<Simulator> reference_simulator(const std::string& scalar, const std::string& timing) {
  return std::make_unique<Reference>(scalar, timing);
}

std::unique_ptr<Simulator> command_simulator(const std::string& command, const std::string& scalar,
                                             const std::string& timing) {
  return std::make_unique<Command>(command, scalar, timing);
}

}  // namespace tps::properties::runs
