#include "properties/implementations/reference.hpp"

#include <algorithm>

#include "properties/implementations/equations_by_name.hpp"
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
  return {"float", "double", "long-double", "quad", "mp50", "mp100", "certified"};
}

std::unique_ptr<Implementation> reference(const std::string& name) {
  if (name == "certified") return std::make_unique<Certified>();
  if (name == "float" || name == "double" || name == "long-double") return equations_in_built_in(name);
  return equations_in_wide(name);
}

}  // namespace tps::properties
