// What a user of tps::verify writes: a certified answer, and a verdict on a trace.
#include <cstdio>

#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

int main(int, char** argv) {
  tps::certified::ExactTiming exact;
  const auto hit = exact.answer({tps::TimingKind::block, {0, 0, 0}, {5, 0, 0}, {1, 0, 0}, {0, 0, 0}, 1});
  const tps::check::CheckReport report = tps::check::check_trace(argv[1], {});
  std::printf("t = %g, %s\n", *hit.t, report.conforming() ? "conforming" : "violated");
}
