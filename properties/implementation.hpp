// An implementation of the operations of the interface (docs/protocol.md), anybody's.
#pragma once

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "properties/format.hpp"
#include "reference/text/number_text.hpp"
#include "verify/operations/catalogue.hpp"

namespace tps::properties {

using Json = nlohmann::ordered_json;
using operations::Op;

/// A number as the protocol spells it: a hexadecimal float that a double has, or "inf".
inline double number_of(const Json& spelled) {
  const std::string& text = spelled.get_ref<const std::string&>();
  return text == "inf" ? HUGE_VAL : parse_hex_float(text).value;
}

/// One operation on given numbers, as the protocol sends it: doubles as hexadecimal floats.
struct Question {
  Op op;
  Json in;
};

struct Answer {
  enum class Status {
    answered,
    skipped,  ///< the operation is not offered
    refused,  ///< there is no answer: 0/0, or beyond the range of its numbers
    failed,   ///< a crash, a hang, or something that is no answer
  };
  Status status = Status::answered;
  Json out = Json::object();  ///< as in the protocol; hexadecimal floats of any length, or JSON numbers
  std::string reason = {};    ///< empty if answered
};

class Implementation {
 public:
  Implementation() = default;
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;
  virtual ~Implementation() = default;

  virtual std::string name() const = 0;
  /// Laws are judged by the unit roundoff 2^-bits of this format.
  virtual Format format() const = 0;
  /// Never throws for what the implementation does.
  virtual Answer ask(const Question& question) = 0;
  /// One after the other, in their order; a program may be sent the next before it has answered the last.
  /// Laws: (1) as long as the answers of ask(). (2) A failure is the answer of the question that it happened
  /// at.
  virtual std::vector<Answer> ask_all(const std::vector<Question>& questions) {
    std::vector<Answer> answers;
    answers.reserve(questions.size());
    for (const Question& question : questions) answers.push_back(ask(question));
    return answers;
  }
  /// The operations that it says it offers; nothing where it does not say.
  virtual std::optional<std::vector<std::string>> offered() const { return std::nullopt; }
  /// Whether it says that it offers one; so it may, where it does not say.
  bool may_offer(Op op) const {
    const auto names = offered();
    return !names || std::find(names->begin(), names->end(), operations::name(op)) != names->end();
  }
  /// Whether groups may have collisions at outer limits; the C header has none.
  virtual bool takes_outer_groups() const { return true; }
  /// What the questions that it takes have and have not, in the words of `tps scene random --features`.
  virtual std::vector<std::string> features() const { return {}; }
  /// Why it is not worth asking any more; empty as long as it is.
  virtual std::string given_up() const { return {}; }
};

}  // namespace tps::properties
