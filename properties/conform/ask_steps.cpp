#include "properties/conform/ask_steps.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>

#include "properties/conform/expected.hpp"
#include "properties/conform/inquiry.hpp"
#include "properties/conform/judge_trace.hpp"
#include "properties/conform/random_scene.hpp"
#include "properties/conform/run_source.hpp"
#include "properties/conform/takes.hpp"
#include "properties/explore/report.hpp"
#include "properties/implementations/reference.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/vectors/check_answers.hpp"

namespace tps::properties::conform {
namespace {

constexpr Op kOperation = Op::next_event;
/// What a state alone does not say: who is loaded, what the clock is.
constexpr const char* kLeftOut[] = {"no-groups", "no-draws", "no-phases", "no-impulses"};
/// A scene's duration does not limit its next event.
constexpr double kForEver = 1e300;

/// A question, and the certified answer to it.
struct Step {
  Question question;
  Json right;
};

Json without_duration(const Scene& scene) {
  Json json = Json::parse(text_of_random(scene, SceneStyle::compact));
  json["duration"] = kForEver;
  json.erase("start_time");
  return json;
}

/// A particle's state after an event, within that; null where there is none.
const Json* state_of(const Json& event, const Json& id) {
  const auto states = event.find("state");
  if (states == event.end()) return nullptr;
  for (const Json& each : *states) {
    if (each.is_object() && each.value("id", Json()) == id) return &each;
  }
  return nullptr;
}

/// Zeros where the scene leaves it out.
Json velocity_of(const Json& particle) {
  return particle.value("velocity", Json(std::vector<double>(particle.at("position").size(), 0)));
}

/// The scene after the event.
void follow(Json& scene, const Json& event) {
  for (Json& particle : scene["particles"]) {
    const Json& state = *state_of(event, particle.at("id"));
    particle["position"] = state.at("position");
    particle["velocity"] = state.at("velocity");
  }
  const std::string tether = event.value("tether", "");
  if (tether.empty()) return;
  const Json pair{event.at("i"), event.at("j")}, turned{event.at("j"), event.at("i")};
  Json kept = Json::array();
  for (const Json& each : scene.value("tethers", Json::array())) {
    if (each != pair && each != turned) kept.push_back(each);
  }
  if (tether == "formed") kept.push_back(pair);
  scene["tethers"] = kept;
}

/// A minimal trace that has this event alone.
std::string trace_of(const Json& scene, const Json& out) {
  const Json header{{"trace", 1}, {"form", "minimal"}, {"positions", "eager"}, {"scene", scene}};
  std::string text = json_text(header) + "\n";
  if (out.value("kind", Json()) == "none")
    return text + json_text(Json{{"end", "no_more_events"}, {"events", 0}, {"t", 0}}) + "\n";
  Json event{{"t", out.value("dt", Json())}};
  for (const char* key : {"kind", "i", "j", "tether"}) {
    if (out.contains(key)) event[key] = out.at(key);
  }
  for (const char* key : {"i", "j"}) {
    const Json id = out.value(key, Json());
    const Json* state = state_of(out, id);
    if (state == nullptr) continue;  // the check misses it
    event["post"][json_text(id)] = {{"position", state->value("position", Json())},
                                    {"velocity", state->value("velocity", Json())}};
  }
  return text + json_text(event) + "\n" +
         json_text(Json{{"end", "max_events"}, {"events", 1}, {"t", out.value("dt", Json())}}) + "\n";
}

/// u + v dt to 1.5(2u|v dt| + u|u'|), as the rule flight of the check has it, and v bit for bit.
std::optional<std::string> wrong_bystander(const Json& particle, const Json& out, double dt) {
  const Json& id = particle.at("id");
  const Json* state = state_of(out, id);
  if (state == nullptr) return fmt::format("the state has no particle {}", json_text(id));
  const auto before = numbers_of(particle.at("position")), v = numbers_of(velocity_of(particle));
  const auto after = numbers_of(state->value("position", Json()));
  const auto v_after = numbers_of(state->value("velocity", Json()));
  if (!after || after->size() != before->size()) return fmt::format("particle {} is nowhere", json_text(id));
  if (v_after != v) {
    return fmt::format("particle {} has no part in the event, and its velocity changes to {}", json_text(id),
                       json_text(state->value("velocity", Json())));
  }
  for (std::size_t k = 0; k < before->size(); ++k) {
    const long double way = static_cast<long double>((*v)[k]) * dt, right = (*before)[k] + way;
    const long double bound = 0x1p-53L * (3 * std::fabs(way) + 1.5L * std::fabs(right)) + 0x1p-1074L;
    if (std::fabs((*after)[k] - right) <= bound) continue;
    return fmt::format("particle {} flies to {} in component {}; right is {}", json_text(id), (*after)[k], k,
                       static_cast<double>(right));
  }
  return std::nullopt;
}

std::optional<std::string> wrong_bystanders(const Json& scene, const Json& out) {
  const bool none = out.value("kind", Json()) == "none";
  const auto dt = none ? std::vector<double>{0} : numbers_of(out.value("dt", Json()));
  if (!dt || dt->size() != 1) return "dt is " + json_text(out.value("dt", Json())) + ", which is no number";
  for (const Json& particle : scene.at("particles")) {
    const Json& id = particle.at("id");
    if (!none && (id == out.value("i", Json()) || id == out.value("j", Json()))) continue;
    if (auto why = wrong_bystander(particle, out, dt->front())) return why;
  }
  return std::nullopt;
}

Grade graded(const Step& step, const Answer& answer, std::string& reading) {
  if (answer.status != Answer::Status::answered) return {Class::refused, answer.reason};
  if (!answer.out.is_object()) return {Class::wrong, "out is no object"};
  const Json& scene = step.question.in.at("scene");
  if (auto why = vectors::wrong_state(answer.out, scene.at("particles").size()))
    return {Class::wrong, std::move(*why)};
  try {
    const check::CheckReport report = checked(json_text(scene), trace_of(scene, answer.out));
    const check::Finding* worst = worst_of(report);
    if (worst != nullptr && class_of(*worst) == Class::wrong) {
      reading = worst->reading;
      return {Class::wrong, words_of(*worst)};
    }
    if (const auto why = wrong_bystanders(scene, answer.out)) return {Class::wrong, *why};
    return worst == nullptr ? Grade{} : Grade{class_of(*worst), words_of(*worst)};
  } catch (const InputError& error) {
    return {Class::wrong, "no event that can be judged: " + first_problem(error)};
  } catch (const Json::exception&) {
    return {Class::wrong,
            "no event that can be judged: its parts are not of the kind that docs/protocol.md has"};
  }
}

Row row_of_kind(const std::string& kind) {
  return row_of(kOperation, "step_" + kind);
}

class Steps {
 public:
  Steps(Implementation& subject, const StepPlan& plan, Verdict& verdict)
      : subject_(subject), plan_(plan), verdict_(verdict), features_(plan.features) {
    std::erase_if(features_, calls_for_effect);  // their events have no certified answer
    features_.insert(features_.end(), std::begin(kLeftOut), std::end(kLeftOut));
  }

  void ask() {
    std::uint64_t asked = 0;
    for (std::uint64_t number = 0; asked < plan_.scenes; ++number) {
      if (plan_.stops() || !subject_.given_up().empty()) break;
      const auto scene = random_scene(features_, plan_.seed, number);
      if (!scene) continue;
      ++asked;
      plan_.progress(fmt::format("{} from states of scene {} of seed {}", operations::name(kOperation),
                                 number, plan_.seed));
      ask(walk(*scene), number);
    }
    for (auto& [kind, row] : rows_) verdict_.rows.push_back(std::move(row));
  }

 private:
  /// States as long as they have one certified next event.
  std::vector<Step> walk(const Scene& first) {
    std::vector<Step> steps;
    Json scene = without_duration(first);
    while (steps.size() < plan_.steps) {
      Question question{kOperation, {{"scene", scene}}};
      Answer right = certified_->ask(question);
      if (right.status != Answer::Status::answered || right.out.contains("simulated")) break;
      const bool ends = right.out.at("kind") == "none";
      if (!ends) follow(scene, right.out);
      steps.push_back({std::move(question), std::move(right.out)});
      if (ends) break;
    }
    return steps;
  }

  void ask(std::vector<Step> steps, std::uint64_t number) {
    std::erase_if(steps, [&](const Step& step) {
      return !plan_.is_asked(row_of_kind(step.right.at("kind").get<std::string>()).name);
    });
    std::vector<Question> questions;
    for (const Step& step : steps) questions.push_back(step.question);
    const std::vector<Answer> answers = subject_.ask_all(questions);
    for (std::size_t n = 0; n < steps.size(); ++n)
      judge(steps[n], answers[n], fmt::format("scene {} of seed {}, step {}", number, plan_.seed, n));
  }

  void judge(const Step& step, const Answer& answer, std::string id) {
    if (answer.status == Answer::Status::failed)
      return verdict_.note_failure({std::move(id), answer.reason, plan_.commands_of(step.question)});
    const std::string kind = step.right.at("kind").get<std::string>();
    Row& row = rows_.try_emplace(kind, row_of_kind(kind)).first->second;
    std::string reading;
    const Grade grade = graded(step, answer, reading);
    row.add(grade, [&] {
      Example shown{grade.which, id, grade.why, {command_of(step.question)}, json_text(step.question.in)};
      if (answer.status == Answer::Status::answered) shown.found = json_text(answer.out);
      shown.right = json_text(step.right);
      return shown;
    });
    if (!reading.empty()) ++row.hypotheses[reading];
  }

  Implementation& subject_;
  const StepPlan& plan_;
  Verdict& verdict_;
  std::vector<std::string> features_;
  std::unique_ptr<Implementation> certified_ = reference("certified");
  std::map<std::string, Row> rows_;
};

}  // namespace

std::vector<std::string> step_rows() {
  std::vector<std::string> names;
  for (const char* kind : {"rebound", "retract", "revolve", "break", "none"})
    names.push_back(row_of_kind(kind).name);
  return names;
}

void ask_steps(Implementation& subject, const StepPlan& plan, Verdict& verdict) {
  Steps(subject, plan, verdict).ask();
}

}  // namespace tps::properties::conform
