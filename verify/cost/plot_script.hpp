// The script of the page: Vega, whose parts plot_script.cmake joins, and plots.js. Part of this program.
#pragma once

#include <string_view>

namespace tps::cost {

struct PlotScript {
  std::string_view text, sha256;
};

/// Empty where Vega was not there when this was built.
PlotScript plot_script();

}  // namespace tps::cost
