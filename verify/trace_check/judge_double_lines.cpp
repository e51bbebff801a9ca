#include "verify/trace_check/judge_lines_impl.hpp"

namespace tps::check {

template void judge_lines<double>(LineSource&, const std::vector<Judgement>&, const Precision<double>&);

}  // namespace tps::check
