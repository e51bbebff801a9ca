#include "properties/implementations/reference.hpp"

#include "properties/implementations/equations.hpp"
#include "properties/implementations/read_reply.hpp"
#include "verify/protocol/conversation.hpp"

namespace tps::properties {
namespace {

/// `tps serve` without its pipes.
class Certified final : public Implementation {
 public:
  std::string name() const override { return "the certified answers"; }
  Format format() const override { return Format::of_bits(53); }
  Answer ask(const Question& question) override {
    return read_reply(protocol::reply_to(request_line(1, question)).text, 1);
  }
};

}  // namespace

std::vector<std::string> reference_names() {
  std::vector<std::string> names = scalar_names();
  names.emplace_back("certified");
  return names;
}

std::unique_ptr<Implementation> reference(const std::string& name) {
  const std::optional<ScalarKind> scalar = scalar_kind(name);
  if (scalar) return equations_in(*scalar);
  return std::make_unique<Certified>();
}

}  // namespace tps::properties
