#include "verify/trace_check/judge_lines_impl.hpp"

namespace tps::check {

std::unique_ptr<LineJudge> judge_of_doubles(const JudgeParts& parts, bool is_float, std::string_view state,
                                            std::uint64_t number) {
  const Precision<double> in_float{0x1p-24L, 0x1p-149L, 24, true};
  const Precision<double> in_double{0x1p-53L, 0x1p-1074L, 53, false};
  return line_judge<double>(parts, is_float ? in_float : in_double, state, number);
}

}  // namespace tps::check
