// The trace and the checkpoint of a run, as files.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "reference/run/run.hpp"
#include "reference/text/background_writer.hpp"
#include "reference/text/output.hpp"
#include "reference/trace/state_data.hpp"

namespace tps {

/// Where a resumed run starts.
struct ResumePoint {
  StateData state;
  std::uint64_t keep = 0;         ///< bytes of the trace to go on behind
  std::string from;               ///< the file that holds them
  std::shared_ptr<Output> trace;  ///< where the run is to go on, open and locked; null where it is a new file
};

/// A full state that the scene of its file cannot have.
class StateDoesNotFit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The first line of a trace or, with kind "checkpoint", of a checkpoint.
/// Of the options, scalar and timing count.
std::string head_line(std::string_view kind, const Scene& scene, const RunOptions& options,
                      std::uint64_t state_every);

/// The last full state of a trace or checkpoint. Throws InputError where there is none.
ResumePoint last_state(const std::string& path);

/// The last full state whose time since the start is at most `until`, if that is given, of a trace of that
/// scene. Throws InputError.
StateData last_state_until(const std::string& path, const Scene& scene, std::optional<double> until);

/// Whether a file is a checkpoint; otherwise it should be a trace. Throws InputError when it cannot be read.
bool is_checkpoint(const std::string& path);

/// The place in a trace behind the full state with number k, or before it where that is a final one. Throws
/// InputError if it holds no such state.
std::uint64_t place_behind_state(const std::string& path, std::uint64_t k);

/// Writes what a run reports to whichever of the two files its options ask for.
class TraceFiles {
 public:
  /// Opens and locks both and touches neither: the start of a run may take long, or be refused.
  TraceFiles(const RunOptions& options, const ResumePoint* resume);

  /// Writes what stands before the first line of the run: the head or, where a run is taken up, what was.
  void begin(const Scene& scene, const RunOptions& options, std::uint64_t state_every,
             const ResumePoint* resume);

  bool has_trace() const { return trace_ != nullptr; }
  bool wants_states() const { return trace_ != nullptr || checkpoint_.has_value(); }
  void line(std::string_view text);
  /// Lines with their ends, of the trace, as Output::write has them made.
  void lines(MakeText make);
  /// A full state, its end included: of both.
  void state(MakeText make);
  /// What there is of the trace is soon to be seen.
  void send();
  /// Waits until nothing handed over is needed any more.
  void settle() noexcept;
  void close();

 private:
  std::shared_ptr<Output> trace_;
  std::optional<ReplacedFile> checkpoint_;
  std::string checkpoint_head_;
};

}  // namespace tps
