// What pages do not ask for is not in the WebAssembly build: runs and evaluations in other scalars.
#include <stdexcept>

#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"
#include "verify/operations/evaluate.hpp"

namespace tps {
namespace {

[[noreturn]] void lacking(const char* scalar) {
  throw std::invalid_argument(std::string("pages compute in float, double and mp50, not in ") + scalar);
}

}  // namespace

template <>
RunSummary run_in<float>(const Scene&, const RunOptions&, const ResumePoint*) {
  lacking("float, where it is a run");
}
template <>
RunSummary run_in<long double>(const Scene&, const RunOptions&, const ResumePoint*) {
  lacking("long-double");
}
template <>
RunSummary run_in<Quad>(const Scene&, const RunOptions&, const ResumePoint*) {
  lacking("quad");
}
template <>
RunSummary run_in<Mp50>(const Scene&, const RunOptions&, const ResumePoint*) {
  lacking("mp50, where it is a run");
}
template <>
RunSummary run_in<Mp100>(const Scene&, const RunOptions&, const ResumePoint*) {
  lacking("mp100");
}

namespace operations {

template <>
Report evaluate_in<long double>(const Operation&, const Input&, std::string_view, Detail) {
  lacking("long-double");
}
template <>
Report evaluate_in<Quad>(const Operation&, const Input&, std::string_view, Detail) {
  lacking("quad");
}
template <>
Report evaluate_in<Mp100>(const Operation&, const Input&, std::string_view, Detail) {
  lacking("mp100");
}

}  // namespace operations
}  // namespace tps
