#include "verify/trace_check/parallel_judge.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "reference/process/without_signals.hpp"

namespace tps::check {
namespace {

/// A segment on its way. It is judged ahead of its turn from its own first state; in its turn that is
/// accepted or, where the segment before does not end there after all, it is judged as what follows.
struct Task {
  enum class Status { waiting, taken, judged };

  Segment segment;
  Status status = Status::waiting;
  std::unique_ptr<LineJudge> judge;  ///< that went through it ahead of its turn; null: nobody could
  std::unique_ptr<Judged> ended;     ///< what it has come to by then, where the next one can begin alone
};

class ParallelJudge {
 public:
  ParallelJudge(Segments& segments, const MakeJudge& make, const ParallelOptions& options, Judged& all)
      : segments_(segments), make_(make), options_(options), all_(all), current_(make("", 0)) {}
  ParallelJudge(const ParallelJudge&) = delete;
  ParallelJudge& operator=(const ParallelJudge&) = delete;
  ~ParallelJudge() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    changed_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
  }

  void run() {
    Lock lock(mutex_);
    while (!has_ended_) {
      if (error_) std::rethrow_exception(error_);
      report_progress();
      if (wants_more()) {
        read(lock);
      } else if (tasks_.empty()) {
        has_ended_ = true;
      } else if (!work(lock, true) && !error_) {
        changed_.wait_for(lock, kBetweenLooks);
      }
    }
    if (error_) std::rethrow_exception(error_);
    all_.take_over(*current_->close(all_.report.lines));
  }

 private:
  using Lock = std::unique_lock<std::mutex>;
  static constexpr auto kBetweenLooks = std::chrono::milliseconds(100);

  bool wants_more() const {
    const bool goes_on = !tasks_.empty() && tasks_.back()->segment.goes_on;
    return !all_read_ && !goes_on && tasks_.size() <= options_.jobs && !is_stopped();
  }
  bool is_stopped() const { return options_.stop(); }

  void report_progress() const {
    if (options_.progress) options_.progress(all_.report.events);
  }

  void read(Lock& lock) {
    lock.unlock();
    std::optional<Segment> next = segments_.next();
    lock.lock();
    if (!next) {
      all_read_ = true;
      return;
    }
    tasks_.push_back(std::make_shared<Task>());
    tasks_.back()->segment = std::move(*next);
    if (tasks_.size() > 1 && helpers_.empty()) start_helpers();
    changed_.notify_all();
  }

  void start_helpers() {
    const WithoutSignals mask;
    for (unsigned n = 1; n < options_.jobs; ++n) helpers_.emplace_back([this] { help(); });
  }
  void help() {
    Lock lock(mutex_);
    while (!is_over_ && !error_) {
      if (!work(lock, false)) changed_.wait(lock);
    }
  }

  /// Does what can be done next; false where nothing can.
  bool work(Lock& lock, bool reads) try {
    if (!in_turn_ && !tasks_.empty()) {
      const std::shared_ptr<Task> first = tasks_.front();
      if (first->status != Task::Status::taken && (reads || !first->segment.goes_on)) {
        in_turn_ = true;
        first->status = first->judge ? Task::Status::judged : Task::Status::taken;
        lock.unlock();
        take_turn(*first);
        lock.lock();
        in_turn_ = false;
        tasks_.pop_front();
        changed_.notify_all();
        return true;
      }
    }
    for (const std::shared_ptr<Task>& task : std::vector(tasks_.begin(), tasks_.end())) {
      if (task->status != Task::Status::waiting || task->segment.goes_on || !pays_ahead()) continue;
      task->status = Task::Status::taken;
      lock.unlock();
      judge_ahead(*task);
      lock.lock();
      task->status = Task::Status::judged;
      changed_.notify_all();
      return true;
    }
    return false;
  } catch (...) {
    if (!lock.owns_lock()) lock.lock();
    if (!error_) error_ = std::current_exception();
    changed_.notify_all();
    return false;
  }

  /// Where segments of a trace turn out to hang together there is no use in judging more of them ahead.
  bool pays_ahead() const { return in_vain_ < 2 + accepted_; }

  void judge_ahead(Task& task) {
    task.judge = make_(task.segment.state, task.segment.first_line - 1);
    if (!task.judge) return;
    segments_.each_line(task.segment, [&](const LineText& line, std::uint64_t number) {
      task.judge->judge(line, number);
      return !task.judge->needed_before() && !is_stopped();
    });
    if (task.segment.ends_at_border && !task.judge->needed_before() && !is_stopped())
      task.ended = task.judge->end_segment();
  }

  /// In the order of the trace, one at a time.
  void take_turn(Task& task) {
    if (is_stopped()) return;
    const bool was_ahead = task.status == Task::Status::judged;
    std::unique_ptr<Judged> ended;
    std::uint64_t last = task.segment.first_line + task.segment.lines - 1;
    if (was_ahead && begins_alone_ && !task.judge->needed_before() && !is_stopped()) {
      ++accepted_;
      current_ = std::move(task.judge);
      ended = std::move(task.ended);
    } else {
      if (was_ahead) ++in_vain_;
      task.judge.reset();
      task.ended.reset();
      bool at_border = task.segment.ends_at_border;
      const Segments::Visit visit = [&](const LineText& line, std::uint64_t number) {
        if (is_stopped()) return false;
        current_->judge(line, number);
        last = number;
        return true;
      };
      segments_.each_line(task.segment, visit);
      if (task.segment.goes_on) at_border = segments_.each_line_of_rest(task.segment, visit);
      if (at_border && !is_stopped()) ended = current_->end_segment();
    }
    begins_alone_ = ended != nullptr;
    const std::lock_guard lock(mutex_);
    if (ended) all_.take_over(*ended);
    all_.report.lines = last;
  }

  Segments& segments_;
  const MakeJudge& make_;
  const ParallelOptions& options_;
  std::mutex mutex_;  ///< of all below, and of the tasks' status
  std::condition_variable changed_;
  Judged& all_;
  std::deque<std::shared_ptr<Task>> tasks_;  ///< in the order of the trace
  std::unique_ptr<LineJudge> current_;       ///< that stands before the first task
  bool begins_alone_ = false;                ///< the first task does
  bool in_turn_ = false;                     ///< somebody has the first task in its turn
  bool all_read_ = false, has_ended_ = false, is_over_ = false;
  std::atomic<std::uint64_t> accepted_ = 0, in_vain_ = 0;
  std::exception_ptr error_;
  std::vector<std::thread> helpers_;
};

}  // namespace

void judge_in_parallel(Segments& segments, const MakeJudge& make, const ParallelOptions& options,
                       Judged& all) {
  ParallelJudge(segments, make, options, all).run();
}

}  // namespace tps::check
