// A verdict as text and for other programs.
#pragma once

#include <string>

#include "properties/conform/verdict.hpp"

namespace tps::properties::conform {

/// The table, what is not right in it, and one sentence. With `every_row` the hazards without a finding, too.
std::string report_text(const Verdict& verdict, bool every_row);

/// The last sentence alone.
std::string sentence(const Verdict& verdict);

/// "block_time.plain.00003: hung: …".
std::string words_of(const Failure& failure);

/// "laws 1, 2, 4–9 of eq. (2) need block_time or tether_time; …"; empty where all were asked.
std::string laws_not_asked_in_words(const Verdict& verdict);

/// What a row says in one line: "125 asked, 122 RIGHT, 3 BEYOND ITS PRECISION".
std::string findings_of(const Row& row);

std::string report_json(const Verdict& verdict);
std::string report_junit(const Verdict& verdict);
std::string report_markdown(const Verdict& verdict);
/// A page of its own, with a picture of each case that has one.
std::string report_html(const Verdict& verdict);
/// A badge that names the profile and the version of the data.
std::string report_svg(const Verdict& verdict);

/// 0 conforming, 1 a row fails or one that may fail does not, 4 the subject crashed, hung or broke the
/// protocol, 5 nothing was asked, 130 interrupted.
int exit_code(const Verdict& verdict);

}  // namespace tps::properties::conform
