#include "verify/protocol/simulate.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "reference/run/run.hpp"
#include "reference/text/input_error.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps::protocol {
namespace {

/// A file without a name or a disk, since a run writes its trace to a file.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("trace", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail();
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }
  std::size_t size() const {
    const off_t end = ::lseek(descriptor_, 0, SEEK_END);
    if (end < 0) fail();
    return static_cast<std::size_t>(end);
  }
  std::string content() const {
    std::string text(size(), '\0');
    for (std::size_t have = 0; have < text.size();) {
      const ssize_t got =
          ::pread(descriptor_, text.data() + have, text.size() - have, static_cast<off_t>(have));
      if (got <= 0) fail();
      have += static_cast<std::size_t>(got);
    }
    return text;
  }

 private:
  [[noreturn]] static void fail() {
    throw std::system_error(errno, std::generic_category(), "cannot keep a trace in memory");
  }

  int descriptor_;
};

}  // namespace

std::string simulate(const JsonValue& in, const operations::Place& place) {
  const operations::SimulateInput input = operations::read_simulate(in, place);
  certified::ExactTiming certifier;
  const MemoryFile file;
  RunOptions options;
  options.timing = Timing::certified;
  options.certifier = &certifier;
  options.max_events = input.max_events;
  options.trace = file.path();
  try {
    run_scene(input.scene, options);
  } catch (const InputError& error) {  // knows the scene, not where it stands
    throw InputError({{place.source, in.line, place.pointer, error.problems().front().message}});
  }
  if (file.size() > kLongestTrace) {
    throw InputError(
        {{place.source, in.line, place.pointer,
          fmt::format("has a trace of {} bytes; a reply has at most {}; ask for fewer events, or "
                      "use `tps run`",
                      file.size(), kLongestTrace)}});
  }
  std::string lines = file.content();
  if (!lines.empty()) lines.pop_back();  // the last end of a line
  std::replace(lines.begin(), lines.end(), '\n', ',');
  return "{\"trace\":[" + lines + "]}";
}

}  // namespace tps::protocol
