#include "verify/trace_check/read_line_impl.hpp"
#include "verify/trace_check/wide.hpp"

namespace tps::check {

template class LineReading<double>;
template class LineReading<Wide>;

}  // namespace tps::check
