#include "reference/text/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include "reference/text/input_error.hpp"

namespace tps {
namespace {

using namespace std::string_view_literals;

constexpr const char* kConvert =
    "convert its particles into a scene (docs/scene.md), or a run of yours into a trace (docs/trace.md)";

struct Magic {
  std::string_view bytes;
  const char* what;
  const char* todo;
};

constexpr std::array kMagics{
    Magic{"\x1f\x8b"sv, "compressed by gzip", "unpack it first: gzip -dc FILE | tps VERB -"},
    Magic{"BZh"sv, "compressed by bzip2", "unpack it first: bzip2 -dc FILE | tps VERB -"},
    Magic{"\xfd"
          "7zXZ\0"sv,
          "compressed by xz", "unpack it first: xz -dc FILE | tps VERB -"},
    Magic{"\x28\xb5\x2f\xfd"sv, "compressed by zstd", "unpack it first: zstd -dc FILE | tps VERB -"},
    Magic{"PK\x03\x04"sv, "a zip archive", "unpack it first"},
    Magic{"\x89HDF"sv, "an HDF5 file, such as H5MD", kConvert},
    Magic{"\xdf\x65\xdf\x65\xdf\x65\xdf\x65"sv, "a GSD file of HOOMD-blue", kConvert},
    Magic{"\x65\xdf\x65\xdf\x65\xdf\x65\xdf"sv, "a GSD file of HOOMD-blue", kConvert},
    Magic{"CDF\x01"sv, "a NetCDF file", kConvert},
    Magic{"CDF\x02"sv, "a NetCDF file", kConvert},
    Magic{"\x93NUMPY"sv, "an array of NumPy", kConvert},
    Magic{"ITEM: "sv, "a dump of LAMMPS", kConvert},
    Magic{"\xff\xfe"sv, "text in UTF-16", "write it in UTF-8"},
    Magic{"\xfe\xff"sv, "text in UTF-16", "write it in UTF-8"},
};

std::vector<std::string_view> first_lines(std::string_view text, std::size_t most) {
  std::vector<std::string_view> lines;
  while (lines.size() < most && !text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t begin = line.find_first_not_of(" \t", at);
    if (begin == std::string_view::npos) break;
    at = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back(line.substr(begin, at - begin));
  }
  return words;
}

bool is_count(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A title, the number of atoms, and atoms in fixed columns: residue, name, number, x, y, z.
bool is_gromacs(const std::vector<std::string_view>& lines) {
  constexpr std::size_t kShortestAtom = 44;
  return lines.size() > 2 && words_of(lines[1]).size() == 1 && is_count(words_of(lines[1])[0]) &&
         lines[2].size() >= kShortestAtom && lines[2].find_first_of("{}[]\",") == std::string_view::npos;
}

/// Two lines with the same number of commas, and no bracket of JSON.
bool is_table(const std::vector<std::string_view>& lines) {
  if (lines.size() < 2) return false;
  const auto commas = [](std::string_view line) { return std::count(line.begin(), line.end(), ','); };
  const bool plain = lines[0].find_first_of("{}[]") == std::string_view::npos &&
                     lines[1].find_first_of("{}[]") == std::string_view::npos;
  return plain && commas(lines[0]) > 0 && commas(lines[0]) == commas(lines[1]);
}

/// The first command is one that an input script begins with.
bool is_lammps_input(const std::vector<std::string_view>& lines) {
  constexpr std::array kFirst{"units"sv,      "atom_style"sv, "dimension"sv,  "boundary"sv,    "newton"sv,
                              "lattice"sv,    "region"sv,     "pair_style"sv, "read_data"sv,   "variable"sv,
                              "processors"sv, "package"sv,    "create_box"sv, "read_restart"sv};
  for (const std::string_view line : lines) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    return words.size() >= 2 && std::find(kFirst.begin(), kFirst.end(), words[0]) != kFirst.end();
  }
  return false;
}

/// A document mark, or "key:" or "key: value" in the first line that is no comment.
bool is_yaml(const std::vector<std::string_view>& lines) {
  for (const std::string_view line : lines) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    const std::string_view key = words[0];
    const bool is_key =
        key.size() > 1 && key.ends_with(':') && key.find_first_of("\"{}[],") == std::string_view::npos;
    return line == "---" || line.starts_with("%YAML") || is_key;
  }
  return false;
}

/// Text formats that begin with no magic.
RecognisedFile recognise_text(std::string_view beginning) {
  const std::vector<std::string_view> lines = first_lines(beginning, 40);
  const std::string_view first = lines.empty() ? "" : lines[0];
  if (first.starts_with('<')) {
    if (beginning.find("DynamOconfig") != std::string_view::npos)
      return {FileKind::foreign, "a configuration of DynamO (XML)", kConvert};
    return {FileKind::foreign, "XML or HTML", kConvert};
  }
  if (lines.size() > 1 && words_of(first).size() == 1 && is_count(words_of(first)[0])) {
    const bool extended = lines[1].find("Lattice=") != std::string_view::npos ||
                          lines[1].find("Properties=") != std::string_view::npos;
    if (extended) return {FileKind::foreign, "extended XYZ", kConvert};
    if (lines.size() > 2 && words_of(lines[2]).size() >= 4)
      return {FileKind::foreign, "an XYZ file", kConvert};
  }
  if (is_gromacs(lines)) return {FileKind::foreign, "a GROMACS structure (.gro)", kConvert};
  if (is_table(lines)) return {FileKind::foreign, "a table with commas (CSV)", kConvert};
  if (is_lammps_input(lines))
    return {FileKind::foreign, "an input script of LAMMPS",
            "write its interactions and its particles as a scene (docs/scene.md)"};
  if (is_yaml(lines))
    return {FileKind::foreign, "YAML", "write it as JSON: scenes, traces and known answers are JSON"};
  for (const std::string_view line : lines) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() >= 2 && is_count(words[0]) && words[1] == "atoms")
      return {FileKind::foreign, "a data file of LAMMPS", kConvert};
  }
  for (const std::string_view record : {"HEADER    ", "CRYST1", "ATOM  ", "HETATM", "REMARK "}) {
    if (first.starts_with(record)) return {FileKind::foreign, "a PDB file", kConvert};
  }
  return {};
}

/// The keys of the object that a JSON text begins with, each with the first character of its value and, of a
/// string, the string. Stops where the beginning ends.
std::map<std::string, std::string> top_keys(std::string_view text) {
  std::map<std::string, std::string> keys;
  std::string key, word;
  int depth = 0;
  bool is_value = false;
  const auto take = [&](const std::string& value) {
    if (depth == 1 && is_value) keys.emplace(key, value);
    is_value = false;
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      word.clear();
      for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
        if (at < text.size()) word.push_back(text[at]);
      }
      if (depth == 1 && !is_value) key = word;
      if (is_value) take("\"" + word);
    } else if (c == ':' && depth == 1) {
      is_value = true;
    } else if (c == '{' || c == '[') {
      take(std::string(1, c));
      ++depth;
    } else if (c == '}' || c == ']') {
      if (--depth == 0) break;
    } else if (std::isspace(static_cast<unsigned char>(c)) == 0 && c != ',') {
      take(std::string(1, c));
    }
  }
  return keys;
}

RecognisedFile recognise_json(std::string_view text) {
  const std::map<std::string, std::string> keys = top_keys(text);
  const auto has = [&](const char* key) { return keys.contains(key); };
  const auto is = [&](const char* key, char first) { return has(key) && keys.at(key)[0] == first; };
  if (has("trace"))
    return {FileKind::trace, "a trace of a run",
            "`tps check FILE` judges it, `tps run --resume FILE` goes on from it"};
  if (has("checkpoint"))
    return {FileKind::checkpoint, "a checkpoint of a run", "`tps run --resume FILE` goes on from it"};
  if (has("schema") && keys.at("schema") == "\"vectors")
    return {FileKind::known_answers, "a file of known answers",
            "`tps vectors verify FILE` proves them, `tps vectors requests FILE` makes requests of them"};
  if (has("law") && has("case"))
    return {FileKind::regressions, "a file of cases of broken laws",
            "`tps properties --replay FILE` asks them"};
  if (has("tps"))
    return {FileKind::scene, "a scene", "`tps run FILE` simulates it, `tps explain FILE` explains it"};
  if (has("op") && has("in"))
    return {FileKind::requests, "a file of requests", "`tps serve < FILE` answers them"};
  if (has("seq") || has("hello") || has("out"))
    return {FileKind::replies, "lines of the protocol",
            "`tps serve < FILE` answers requests, `tps vectors verify V --answers FILE` judges replies"};
  if (is("config", '{') || (is("species", '{') && is("particles", '{')))
    return {FileKind::arslab_tps, "a scenario of the program ARSLab_TPS",
            "`tps import FILE -o scene.json` turns it into a scene"};
  return {};
}

}  // namespace

RecognisedFile recognise_file(std::string_view beginning) {
  beginning = beginning.substr(0, kBytesThatTell);
  for (const Magic& magic : kMagics) {
    if (beginning.starts_with(magic.bytes)) return {FileKind::foreign, magic.what, magic.todo};
  }
  const std::size_t begin = beginning.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  if (beginning[begin] == '{') return recognise_json(beginning.substr(begin));
  return recognise_text(beginning);
}

void refuse_other_kinds(std::string_view beginning, const std::string& name, std::string_view wanted_here,
                        std::initializer_list<FileKind> wanted) {
  const RecognisedFile file = recognise_file(beginning);
  if (file.kind == FileKind::unknown || std::find(wanted.begin(), wanted.end(), file.kind) != wanted.end())
    return;
  throw InputError(
      {{name, 0, "", fmt::format("is {}; {} is wanted here. {}", file.what, wanted_here, file.todo)}});
}

void refuse_other_kinds_of_file(const std::string& path, std::string_view wanted_here,
                                std::initializer_list<FileKind> wanted) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  std::ifstream in(path, std::ios::binary);
  std::string beginning(kBytesThatTell, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  refuse_other_kinds(beginning, path, wanted_here, wanted);
}

}  // namespace tps
