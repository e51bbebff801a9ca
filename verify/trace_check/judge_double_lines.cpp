#include "verify/trace_check/judge_lines_in.hpp"

namespace tps::check {

template void judge_lines<double>(LineSource&, const TraceFacts&, const Precision<double>&, Tally&,
                                  CheckReport&);

}  // namespace tps::check
