#include "properties/cli/replay_files.hpp"

#include <filesystem>
#include <fstream>

#include "properties/explore/explore.hpp"
#include "properties/explore/regressions.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/input_error.hpp"

namespace tps::cli {
namespace {

using namespace tps::properties;

void replay_file(const std::string& path, bool bitwise, Implementation& subject, Replayed& replay) {
  refuse_other_kinds_of_file(path, "a file of cases of broken laws", {FileKind::regressions});
  std::ifstream file(path, std::ios::binary);
  std::error_code unknown;
  if (!file || std::filesystem::is_directory(path, unknown))
    throw InputError({{path, 0, "", "cannot be read; name regression files"}});
  using Kind = properties::Outcome::Kind;
  for (const Regression& regression : read_regressions(file, path)) {
    if (!fits(regression.shrunk, subject.format()) || !subject.given_up().empty()) {
      ++replay.not_asked;
      continue;
    }
    const Examined found = examine(*regression.law, subject, regression.shrunk, bitwise);
    const Kind kind = found.outcome.kind;
    if (found.outcome.is_finding()) {
      replay.findings.push_back(
          {regression.law, 0, regression.shrunk, regression.shrunk, found.outcome, found.questions});
    } else {
      ++(kind == Kind::holds || kind == Kind::rounding ? replay.held : replay.not_asked);
    }
  }
}

}  // namespace

Replayed replay_files(const std::vector<std::string>& paths, bool bitwise, Implementation& subject) {
  Replayed replay{subject.name(), 0, 0, {}};
  for (const std::string& path : paths) replay_file(path, bitwise, subject, replay);
  return replay;
}

}  // namespace tps::cli
