#include "properties/implementations/equations.hpp"

#include "properties/implementations/ask_equation.hpp"
#include "reference/run/grouped_bodies.hpp"

namespace tps::properties {
namespace {

Coordinates vector_of(const Json& list) {
  Coordinates x{};
  for (std::size_t k = 0; k < list.size(); ++k) x[k] = number_of(list[k]);
  return x;
}

GroupedBodies bodies_of(const Json& in) {
  GroupedBodies group;
  group.dimension = static_cast<int>(in.at("bodies").at(0).at("v").size());
  for (const Json& body : in.at("bodies")) {
    group.bodies.push_back({number_of(body.at("m")), vector_of(body.at("u")), vector_of(body.at("v"))});
  }
  for (const Json& c : in.at("collisions")) {
    const int i = c.at("i").get<int>(), j = c.at("j").get<int>();
    if (c.value("limit", "inner") != "outer") {
      group.collisions.push_back({i, j, Limit::inner, number_of(c.at("c"))});
      continue;
    }
    group.collisions.push_back({i, j, Limit::outer, number_of(c.at("c_retract")),
                                number_of(c.at("c_revolve")), number_of(c.at("theta_revolve_deg"))});
  }
  return group;
}

class Equations final : public Implementation {
 public:
  explicit Equations(ScalarKind scalar)
      : scalar_(scalar), name_(scalar_names()[static_cast<std::size_t>(scalar)]) {}

  std::string name() const override { return "the equations in " + name_; }
  Format format() const override { return Format::of_bits(significant_bits(scalar_)); }
  Answer ask(const Question& question) override {
    if (question.op != Op::group) return ask_equation(question, name_);
    const GroupedVelocities found = group_bodies(bodies_of(question.in), scalar_);
    if (!found.out_of_range.empty())
      return {Answer::Status::refused, {}, found.out_of_range + " is beyond the range of the scalar"};
    return {Answer::Status::answered, {{"loaded", found.loaded}, {"restituted", found.restituted}}};
  }

 private:
  ScalarKind scalar_;
  std::string name_;
};

}  // namespace

std::unique_ptr<Implementation> equations_in(ScalarKind scalar) {
  return std::make_unique<Equations>(scalar);
}

}  // namespace tps::properties
