// The viewer's program and style, from site/viewer/ and three.js: part of this program.
#pragma once

#include <string_view>
#include <vector>

namespace tps::view {

struct ViewerFile {
  std::string_view name, sha256, text;
};

/// Whether three.js was there when this was built.
bool has_viewer();
/// Style and scripts, in the order in which a page has them.
const std::vector<ViewerFile>& viewer_files();
/// The elements of the page.
std::string_view viewer_markup();

}  // namespace tps::view
