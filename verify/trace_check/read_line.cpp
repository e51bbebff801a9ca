#include "verify/trace_check/read_line_in.hpp"
#include "verify/trace_check/wide.hpp"

namespace tps::check {

template class LineReading<double>;
template class LineReading<Wide>;

}  // namespace tps::check
