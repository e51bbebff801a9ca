#include "tests/fuzz/run_and_check.hpp"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/input_error.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::fuzz {
namespace {

constexpr std::size_t kMostParticles = 12;
constexpr std::uint64_t kEvents = 200;

struct Scratch {
  std::string path =
      (std::filesystem::temp_directory_path() / ("tps_fuzz_" + std::to_string(::getpid()))).string();
  ~Scratch() { std::filesystem::remove(path); }
};

}  // namespace

void run_and_check(std::string_view bytes) {
  Scene scene;
  try {
    scene = read_scene_text(bytes, "fuzz");
  } catch (const InputError&) {
    return;
  }
  if (scene.particles.size() > kMostParticles) return;
  const Scratch scratch;
  RunOptions options;
  options.trace = scratch.path;
  options.max_events = kEvents;
  options.state_every = 50;
  try {
    run_scene(scene, options);
  } catch (const InputError&) {
    return;  // a scene whose numbers the scalar cannot carry
  }
  const check::CheckReport report = check::check_trace(scratch.path, {});
  if (!report.conforming()) throw std::logic_error(check::report_text(report));
}

}  // namespace tps::fuzz
