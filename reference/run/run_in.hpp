// run_scene for one scalar and one dimension. Included by the instantiating files only.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include "reference/run/audit.hpp"
#include "reference/run/clusters.hpp"
#include "reference/run/end_of_times.hpp"
#include "reference/run/event_batches.hpp"
#include "reference/run/run.hpp"
#include "reference/run/sample_data.hpp"
#include "reference/run/scene_in_scalar.hpp"
#include "reference/run/trace_file.hpp"
#include "reference/trace/capture.hpp"
#include "reference/trace/event_line.hpp"

namespace tps {

template <typename Scalar, int D>
class RecordedRun {
 public:
  RecordedRun(const Scene& scene, const RunOptions& options, const ResumePoint* resume)
      : scene_(scene),
        options_(options),
        duration_(options.until.value_or(scene.duration)),
        horizon_(clock_until<Scalar>(scene, duration_)),
        state_every_(options.state_every != 0 ? options.state_every : default_state_every(scene)),
        files_(options, resume),
        simulation_(std::in_place, scene, TimingChoice{options.timing, options.certifier}, options.detector),
        events_(scene, files_),
        schedule_(scene, scene.duration) {
    if (resume != nullptr) {
      take_up(*resume);
      require_end_ahead(scene, duration_, horizon_, world().now);
    }
    simulation_->set_horizon(asked_until());
    next_ = simulation_->next_time();
    files_.begin(scene, options, state_every_, resume);
    keep_state(false);
    if (resume == nullptr) write_state();
    first_event_ = world().events;
    listen();
  }

  RunSummary run() {
    const auto start = std::chrono::steady_clock::now();
    EndReason reason = run_events();
    if (reason == EndReason::duration && !everyone_is_in_range(end_time(reason))) {
      reason = EndReason::out_of_range;
    }
    const Time<Scalar> end = end_time(reason);
    if (reason != EndReason::out_of_range) {
      schedule_.sample_until(world(), std::min(next_, after_end(end)), samples_);
    }
    if (files_.wants_states()) keep_state(true);
    write_state();
    if (files_.has_trace()) {
      const std::string t = time_of_end(reason, end);
      files_.line("{\"end\":\"" + std::string(name(reason)) + "\",\"events\":" +
                  std::to_string(world().events) + ",\"t\":\"" + t + "\"" + clock_member(scene_, end) + "}");
    }
    files_.close();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return summarise(reason, end, seconds.count());
  }

 private:
  const World<Scalar, D>& world() const { return simulation_->world(); }

  /// Before the files are touched: a state that does not fit costs nothing. Throws StateDoesNotFit,
  /// OutOfRange.
  void take_up(const ResumePoint& resume) try {
    restore(*simulation_, resume.state);
    for (const std::vector<Hex>& data : resume.state.observations) samples_.push_back(sample_from(data));
  } catch (const OutOfRange&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::out_of_range&) {
    throw StateDoesNotFit("it names a particle, event or quantity that the scene does not have");
  } catch (const std::exception& error) {
    throw StateDoesNotFit(error.what());
  }

  EndReason run_events() {
    const Time<Scalar> end = horizon_;
    auto last_report = std::chrono::steady_clock::now();
    for (std::uint64_t steps = 0;; ++steps) {
      if (options_.interrupt != nullptr && options_.interrupt->load()) return EndReason::interrupted;
      if (simulation_->stalled()) return EndReason::stalled;
      if (options_.max_events && world().events >= *options_.max_events) return EndReason::max_events;
      if (next_ == Time<Scalar>::never() && end == next_) return reason_of_silence();
      if (end < next_) return duration_ < kForEver ? EndReason::duration : reason_at_the_last_clock();
      const std::uint64_t before = world().events;
      if (!step()) return EndReason::out_of_range;
      if (before / state_every_ != world().events / state_every_) {
        keep_state(false);
        write_state();
      }
      if (steps % kStepsBetweenLooks != 0) continue;
      const auto now = std::chrono::steady_clock::now();
      if (now - last_report < std::chrono::milliseconds(100)) continue;
      last_report = now;
      events_.hand_over();
      files_.send();
      if (options_.progress) {
        options_.progress({time_about(world().now), duration_, world().events});
      }
    }
  }

  /// The time t of a clock, with drag not the clock itself: near enough to be looked at.
  double time_about(const Time<Scalar>& now) const {
    const auto s = static_cast<double>(now.hi);
    return scene_.drag ? -std::log1p(-scene_.drag->gamma * s) / scene_.drag->gamma : s;
  }

  /// One step, whose lines are written once it is done. @return false where a number left the range: then
  /// everything is as it was before the step.
  bool step() {
    const std::uint64_t before = world().events;
    try {
      schedule_.sample_until(world(), next_, samples_);
      simulation_->step();
      next_ = simulation_->next_time();  // a detector may ask pairs only now
    } catch (const OutOfRange& problem) {
      out_of_range_ = problem.what();
      events_.drop_step();
      simulate_again(before);
      return false;
    }
    events_.end_step();
    return true;
  }

  /// A step that broke off has changed some of the state. Since a run is a function of its last full state,
  /// simulating from there gives what was before it.
  void simulate_again(std::uint64_t events) {
    events_.hand_over();
    files_.settle();  // events name what the simulation holds
    simulation_.emplace(scene_, TimingChoice{options_.timing, options_.certifier}, options_.detector);
    simulation_->set_horizon(asked_until());
    restore(*simulation_, *last_state_);
    while (world().events < events) simulation_->step();
    listen();
  }

  Time<Scalar> asked_until() const {
    return has_times_behind(scene_, duration_, horizon_) ? Time<Scalar>::never() : horizon_;
  }

  void listen() {
    simulation_->world().sink = [this](const Record<Scalar, D>& record) { note(record); };
  }

  /// No event at any finite time: none at all, or one whose time the scalar does not reach.
  EndReason reason_of_silence() { return reason_of(simulation_->waits_behind()); }

  /// Of a run for ever with drag: what γ s ≥ 1 would bring does not happen, anything else has a time that
  /// nobody can print.
  EndReason reason_at_the_last_clock() {
    if (!has_times_behind(scene_, duration_, horizon_) || is_never_reached(scene_.drag->gamma, next_))
      return EndReason::no_more_events;
    return reason_of(simulation_->waits_behind(horizon_));
  }

  EndReason reason_of(const std::optional<std::string>& who) {
    if (!who) return EndReason::no_more_events;
    out_of_range_ = "the time of the next event of " + *who;
    return EndReason::out_of_range;
  }

  bool everyone_is_in_range(const Time<Scalar>& end) {
    for (int i = 0; i < world().size(); ++i) {
      if (is_finite<Scalar, D>(world().position(i, end))) continue;
      out_of_range_ = "the position of " + particle_name(scene_, i) + " at the end of the duration";
      return false;
    }
    return true;
  }

  /// A run that ended because time was up has reached the end of its duration; any other stands at its last
  /// event.
  Time<Scalar> end_time(EndReason reason) const {
    return reason == EndReason::duration ? horizon_ : world().now;
  }
  /// The same on the scene's clock. Under drag the run's stops short of the duration by less than an ulp.
  std::string time_of_end(EndReason reason, const Time<Scalar>& end) const {
    if (scene_.drag && reason == EndReason::duration)
      return exact_time(scene_.start_time, Time<double>{duration_, 0});
    return time_of(scene_, end);
  }
  /// Samples that are due at the end itself are taken; later ones are not.
  static Time<Scalar> after_end(const Time<Scalar>& end) { return after(end, Scalar(coming_after(end.hi))); }
  static Scalar coming_after(const Scalar& t) {
    return std::numeric_limits<Scalar>::epsilon() * (t + Scalar(1));
  }

  void note(const Record<Scalar, D>& record) {
    if (files_.has_trace()) events_.add(record);
    last_involved_.push_back(record.i);
    last_involved_.push_back(record.j);
    while (last_involved_.size() > kLastInvolved) last_involved_.pop_front();
  }

  void keep_state(bool final) {
    if (last_state_.use_count() > 1) files_.settle();  // a large one is not kept twice
    last_state_ = {};
    StateData state = capture(*simulation_);
    state.final = final;
    if (files_.wants_states()) {
      for (const ClusterSample& sample : samples_) state.observations.push_back(sample_data(sample));
    }
    last_state_ = std::make_shared<const StateData>(std::move(state));
  }

  void write_state() {
    if (!files_.wants_states()) return;
    events_.hand_over();
    files_.state([state = last_state_, t = time_of(scene_, world().now)](std::string& text) {
      text.append(tps::write_state(*state, t)).push_back('\n');
    });
  }

  RunSummary summarise(EndReason reason, const Time<Scalar>& end, double seconds) const;
  void summarise_conservation(RunSummary& s) const;
  void summarise_drag(RunSummary& s, const Time<Scalar>& end) const;
  void summarise_effects(RunSummary& s, const Time<Scalar>& end) const;
  void summarise_groups(RunSummary& s, const Time<Scalar>& end) const;
  std::vector<RunSummary::Final> final_states(const Time<Scalar>& end) const;
  std::vector<std::string> stalled_particles() const;

  static constexpr std::uint64_t kStepsBetweenLooks = 64;
  static constexpr std::size_t kLastInvolved = 200;
  static constexpr double kForEver = std::numeric_limits<double>::infinity();

  const Scene& scene_;
  const RunOptions& options_;
  double duration_;
  Time<Scalar> horizon_;  ///< the duration on the run's clock
  std::uint64_t state_every_;
  std::vector<ClusterSample> samples_;
  TraceFiles
      files_;  ///< before the simulation, whose start takes long: whoever may not write hears it at once
  std::optional<Simulation<Scalar, D>> simulation_;
  Time<Scalar> next_;  ///< of the next event: looked for with the step before it, which may then be undone
  EventBatches<Scalar, D> events_;  ///< behind the simulation, of which it holds names
  ClusterSchedule schedule_;
  std::uint64_t first_event_ = 0;
  std::deque<int> last_involved_;
  std::shared_ptr<const StateData> last_state_;
  std::string out_of_range_;
};

}  // namespace tps

#include "reference/run/recorded_run_summary.hpp"

namespace tps {

/// Before a run starts: what its scene holds, in the scalar of the run. A start from which a number leaves
/// the range at once is as little a start as one that holds such a number.
template <typename Scalar, int D>
RunSummary run_in_dimension(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  if (resume == nullptr) require_scene_in_scalar<Scalar, D>(scene, options);
  std::optional<RecordedRun<Scalar, D>> run;
  try {
    run.emplace(scene, options, resume);
  } catch (const OutOfRange& problem) {
    refuse_start<Scalar>(problem.what());
  }
  return run->run();
}

template <typename Scalar>
RunSummary run_in(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  if (scene.dimension == 2) return run_in_dimension<Scalar, 2>(scene, options, resume);
  return run_in_dimension<Scalar, 3>(scene, options, resume);
}

}  // namespace tps
