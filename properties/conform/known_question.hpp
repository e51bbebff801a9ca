// Questions with certified answers, in the numbers of a format: the strata of the known answers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "properties/format.hpp"
#include "properties/implementation.hpp"

namespace tps::properties::conform {

/// One case of a stratum.
struct KnownQuestion {
  std::string id, stratum;
  Question question;
  Json answer;              ///< as in known-answer files: verdict, t, out, nearest, cond, also, accept
  bool is_sibling = false;  ///< of the last question before it that is none (siblings.hpp)
};

/// Cases of one stratum: questions of one operation that aim at one hazard.
struct Stratum {
  Op op;
  std::string name, why;
  std::vector<KnownQuestion> cases;
};

/// How many cases of which strata.
struct Selection {
  int level = 2;                                                  ///< 1 ten of each, 2 those of data/vectors
  std::function<bool(Op)> wants_op;                               ///< asked before anything is made
  std::function<bool(const std::string& stratum)> wants_stratum;  ///< by "op.stratum"
  bool outer_groups = true;                                       ///< groups with collisions at outer limits
};

/// Makes the selected strata one after the other, as long as `visit` says so; on another thread, while
/// `visit` is busy with those before. A format of fewer bits than double is asked about the nearest numbers
/// that it has, and answers are those to these; what becomes no question, leaves the range of the format, or
/// is a whole scene is left out. Behind the first stratum of an operation come siblings (siblings.hpp) of its
/// first cases. Law: (1) the same cases in every call.
void for_known_questions(const Selection& selection, const Format& format,
                         const std::function<bool(Stratum)>& visit);

}  // namespace tps::properties::conform
