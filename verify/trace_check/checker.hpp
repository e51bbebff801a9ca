// The check of one trace, line by line.
#pragma once

#include <map>
#include <optional>

#include "verify/trace_check/agenda.hpp"
#include "verify/trace_check/below_rounding.hpp"
#include "verify/trace_check/neighbours.hpp"
#include "verify/trace_check/paths.hpp"
#include "verify/trace_check/restored_model.hpp"
#include "verify/trace_check/rules/bystanders.hpp"
#include "verify/trace_check/rules/contact.hpp"
#include "verify/trace_check/rules/drag.hpp"
#include "verify/trace_check/rules/earliest.hpp"
#include "verify/trace_check/rules/flight.hpp"
#include "verify/trace_check/rules/friction.hpp"
#include "verify/trace_check/rules/groups.hpp"
#include "verify/trace_check/rules/known_events.hpp"
#include "verify/trace_check/rules/order.hpp"
#include "verify/trace_check/rules/progress.hpp"
#include "verify/trace_check/rules/states.hpp"
#include "verify/trace_check/rules/tethers.hpp"
#include "verify/trace_check/rules/wall_rebound.hpp"
#include "verify/trace_check/trace_facts.hpp"

namespace tps::check {

/// When everybody began to wait: what of a segment of a trace the next one needs and no full state holds.
template <typename Number>
struct Waits {
  Border<Number> border;
  StepNumber step = 0;
  std::vector<StepNumber> changed_at;  ///< the step in which a particle began its flight; walls: none
  /// The step of an effect's last event, by whom it waits for.
  std::map<std::pair<std::string_view, int>, StepNumber> acted_at;
};

/// Where a check begins that does not begin at the start.
template <typename Number>
struct TakenUp {
  const StateData& state;
  const Waits<Number>* waits;  ///< null: not known
};

template <typename Number>
class Checker {
 public:
  using W = Work<Number>;

  /// From the start of the scene or, where `taken_up` is given, from a full state. Throws std::exception
  /// where that is no state of the scene.
  Checker(const TraceFacts& facts, const Precision<Number>& precision, Tally& tally,
          const std::optional<TakenUp<Number>>& taken_up = std::nullopt);

  Checker(const Checker&) = delete;
  Checker& operator=(const Checker&) = delete;

  void take(const EventLine<Number>& event);
  void take(const StateLine<Number>& state);
  void take(const EndLine<Number>& end);
  /// There is a line that says the end, but not what an end has to say.
  void note_unreadable_end() { end_is_unreadable_ = true; }
  /// The trace is over; without an end it was cut off.
  void close();

  /// Whether another check can go on from the full state that has just been taken, and does not begin before
  /// it: then everybody has been asked up to there. (docs/check.md, "Segments")
  bool ends_segment();
  Waits<Number> waits() const;
  /// Whether a verdict hung on what `taken_up` left out.
  bool needed_before() const { return turns_.needed_before(); }

  const Model<Number>& model() const { return model_; }
  const BelowRounding& below_rounding() const { return below_rounding_; }
  std::uint64_t exact_comparisons() const { return exact_.counters().order.uncertain; }

 private:
  std::string shown_time(const Instant<Number>& t) const {
    if (model_.scene.drag) return fmt::format("s = {:.17g}", static_cast<double>(t.hi));
    return fmt::format("t = {:.17g}", static_cast<double>(t.hi) + model_.scene.start_time);
  }

  Turn<Number> turn_of_event(const EventLine<Number>& event);
  Turn<Number> turn_at_wall(const EventLine<Number>& event);
  /// Whether a time of a minimal trace lies before the present by its rounding alone.
  bool is_now_by_rounding(const Instant<Number>& t) const;
  void take_turn(const EventLine<Number>& event);
  void say_unknown(Kind kind);
  void judge_collision(const Context<Number>& c, const EventLine<Number>& event);
  void expect(const EventLine<Number>& event) const;

  static std::optional<Border<Number>> border_of(const std::optional<TakenUp<Number>>& taken_up,
                                                 const Precision<Number>& precision);
  void make_agendas(const TraceFacts& facts);
  Told told_of(int i, int j) const;
  void note_told(int i, int j, const Told& told);
  std::optional<FirstLook> first_look(int i, const Instant<Number>& until,
                                      const Happening<Number>& happening) const;
  double longer(const Instant<double>& until) const;
  bool is_clear(const FirstLook& look, int i, int j, const Instant<double>& until) const;
  bool flew_apart(const FirstLook& look, int i, int j, const Instant<double>& until) const;
  void judge_meeting(int i, int j, const Instant<Number>& until, const Happening<Number>& happening);
  void ask(int i, int j, const Instant<Number>& until, const Happening<Number>& happening);
  bool is_arrival_alone(int a, int b, const Instant<Number>& until, const Happening<Number>& happening) const;
  void judge_meetings(int i, const Instant<Number>& until, const Happening<Number>& happening);
  void judge_at_walls(int i, const Instant<Number>& until, const Happening<Number>& happening);
  void judge_with_everybody(int i, const Instant<Number>& until, const Happening<Number>& happening);
  void renew_anchors(const Instant<Number>& until, const Happening<Number>& happening);
  void place(int i, const Instant<Number>& now);

  Path path_of(int i) const;
  void judge_until_end(const Instant<Number>& end, Until until);
  void judge_ahead(const Instant<Number>& until, const Happening<Number>& happening);
  void judge_left(const Instant<Number>& end, std::vector<LeftWaiting>& left);

  const std::vector<int>& changing(const EventLine<Number>& event);
  void follow(const EventLine<Number>& event, const std::vector<int>& changed);
  void follow_load(const EventLine<Number>& event);
  void follow_restitution(const EventLine<Number>& event);
  W speeds_of(int i, int j) const;
  void begin_flight(const EventLine<Number>& event, int i, const Vec<Number>& velocity,
                    const W& drift = W(0));
  void follow_unsaid(const EventLine<Number>& event, int i, const Vec<Number>& velocity);

  Model<Number> model_;
  Tally& tally_;
  Timing timing_;
  bool minimal_;
  certified::ExactTiming exact_;
  Turns<Number> turns_;
  const Context<Number> context_;
  Neighbours neighbours_;
  std::vector<std::vector<int>> permanent_;     ///< partners by a permanent tether, by particle
  std::vector<std::optional<Agenda>> agendas_;  ///< of particles with very many of these, by particle
  std::vector<int> with_agenda_;
  std::array<double, 3> edges_{};   ///< of a periodic box; 0 along an open axis
  Waits<Number> waits_;             ///< but for its border
  std::vector<std::size_t> looks_;  ///< at others, by particle, while anchors are renewed
  std::vector<int> changing_;       ///< at the event that is being judged
  bool earliest_held_ = true, bounds_held_ = true;
  /// What has been said about pairs, by particle, during its present flight.
  std::vector<SmallMap<int, Told>> told_;
  std::optional<Arrival<Number>> arrival_;  ///< of the collision that is being judged
  bool arrival_is_judged_ = false;          ///< by rules earliest and bounds, on its whole flight
  std::optional<BodiesNow<Number>> bodies_;
  Expected<W> expected_;
  BelowRounding below_rounding_;
  bool state_holds_ = false;  ///< the last full state is what the events made
  bool ended_ = false;
  bool end_is_unreadable_ = false;
};

}  // namespace tps::check
