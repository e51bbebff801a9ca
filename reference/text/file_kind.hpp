// What a file is, by how it begins: our own kinds and the formats of the field, so that whoever is given the
// wrong one can say so.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace tps {

enum class FileKind {
  unknown,  ///< by its beginning it may be anything
  scene,
  trace,
  checkpoint,
  known_answers,
  regressions,
  requests,
  replies,
  arslab_tps,  ///< a scenario of that program
  foreign,     ///< none that any verb reads
};

struct RecognisedFile {
  FileKind kind = FileKind::unknown;
  std::string what;  ///< "a trace of a run"
  std::string todo;  ///< "`tps check FILE` judges it"
};

/// As much of a file as recognise_file() looks at.
inline constexpr std::size_t kBytesThatTell = std::size_t{1} << 16;

RecognisedFile recognise_file(std::string_view beginning);

/// Throws InputError where the beginning is that of another kind than those wanted, with what it is, what is
/// wanted here ("a scene"), and what to do. Unknown ones pass: whoever reads them knows better what is wrong.
void refuse_other_kinds(std::string_view beginning, const std::string& name, std::string_view wanted_here,
                        std::initializer_list<FileKind> wanted);

/// The same of a regular file that is not open yet; of anything else nothing is read.
void refuse_other_kinds_of_file(const std::string& path, std::string_view wanted_here,
                                std::initializer_list<FileKind> wanted);

}  // namespace tps
