#include "verify/view/checked_page.hpp"

#include "verify/view/page.hpp"

namespace tps::view {

std::string checked_page(const std::string& trace, const std::string& scene,
                         const check::CheckReport& report) {
  require_viewer();
  PlaybackOptions options;
  options.scene = scene;
  options.lines = lines_of(report);
  const Playback playback = read_playback(trace, options);
  return page(playback, shown_findings(report, playback.scene));
}

}  // namespace tps::view
