// The page that plays a trace: one HTML file that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "verify/view/findings.hpp"
#include "verify/view/playback.hpp"

namespace tps::view {

/// Throws std::runtime_error with the remedy where this program was built without three.js, which a page
/// carries.
void require_viewer();

/// A self-contained HTML 5 document: program, style and data inside, nothing loaded from elsewhere, and a
/// content security policy that forbids it. REQUIRES require_viewer() passes.
///
/// (1) Titles, names and messages are data in JSON, in which no character of markup stands ("<", ">", "&" are
/// escapes); the page shows them as text. (2) Numbers are the doubles of the playback, bit by bit, in
/// base64. (3) A pure function of its arguments.
std::string page(const Playback& playback, const std::vector<ShownFinding>& findings);

}  // namespace tps::view
