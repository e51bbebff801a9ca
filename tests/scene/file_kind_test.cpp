// What a file is, by how it begins.
#include "reference/text/file_kind.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "reference/text/input_error.hpp"

namespace tps {
namespace {

using namespace std::string_literals;

std::string beginning_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(FileKind, FormatsOfTheField) {
  const std::pair<std::string, const char*> files[] = {
      {"\x1f\x8b\x08", "gzip"},
      {"BZh91AY", "bzip2"},
      {"\xfd"
       "7zXZ\0\0"s,
       "xz"},
      {"\x89HDF\r\n\x1a\n", "HDF5"},
      {"\x89HDF", "HDF5"},
      {"\xdf\x65\xdf\x65\xdf\x65\xdf\x65", "GSD"},
      {"ITEM: TIMESTEP\n0\n", "dump of LAMMPS"},
      {"LAMMPS data file\n\n 2 atoms\n 1 bonds\n", "data file of LAMMPS"},
      {"# made by hand\r\n\r\n2 atoms\r\n", "data file of LAMMPS"},
      {"2\nLattice=\"1 0 0 0 1 0 0 0 1\"\nH 0 0 0\nH 1 0 0\n", "extended XYZ"},
      {"2\nProperties=species:S:1:pos:R:3\nH 0 0 0\n", "extended XYZ"},
      {"1\nwater\nH 0 0 0\n", "XYZ"},
      {"<?xml version=\"1.0\"?>\n<DynamOconfig>", "DynamO"},
      {"<!DOCTYPE html>", "XML or HTML"},
      {"CRYST1   10.000", "PDB"},
      {"Water, t= 0.0\n    2\n    1WATER  OW1    1   0.126   1.624   1.679\n", "GROMACS"},
      {"id,x,y\n0,1,2\n", "CSV"},
      {"0.0,1.0\n2.0,3.0\n", "CSV"},
      {"# melt\n\nunits lj\natom_style atomic\n", "input script of LAMMPS"},
      {"# scene\nspecies:\n  A: {mass: 1}\n", "YAML"},
      {"---\ntps: 1\n", "YAML"},
  };
  for (const auto& [text, what] : files) {
    const RecognisedFile found = recognise_file(text);
    EXPECT_EQ(found.kind, FileKind::foreign) << text;
    EXPECT_NE(found.what.find(what), std::string::npos) << found.what << " is not " << what;
    EXPECT_FALSE(found.todo.empty());
    EXPECT_THROW(refuse_other_kinds(text, "file", "a scene", {FileKind::scene}), InputError);
  }
}

TEST(FileKind, OurOwn) {
  for (const auto& entry : std::filesystem::directory_iterator(TPS_SOURCE_DIR "/data/scenes"))
    EXPECT_EQ(recognise_file(beginning_of(entry.path())).kind, FileKind::scene) << entry.path();
  for (const auto& entry : std::filesystem::directory_iterator(TPS_SOURCE_DIR "/data/vectors"))
    EXPECT_EQ(recognise_file(beginning_of(entry.path())).kind, FileKind::known_answers) << entry.path();
  EXPECT_EQ(recognise_file(beginning_of(TPS_SOURCE_DIR "/data/regressions/examples.jsonl")).kind,
            FileKind::regressions);
  EXPECT_EQ(recognise_file(beginning_of(TPS_SOURCE_DIR "/tests/import/data/without_config.json")).kind,
            FileKind::arslab_tps);
  EXPECT_EQ(recognise_file("{\"scene\":{\"tps\":1},\"trace\":1}").kind, FileKind::trace) << "in any order";
  EXPECT_EQ(recognise_file("{\"seq\":1,\"op\":\"load\",\"in\":{\"trace\":1}}").kind, FileKind::requests);
  EXPECT_EQ(recognise_file("{\"seq\":1,\"out\":{}}").kind, FileKind::replies);
}

TEST(FileKind, WhatMayBeAnythingPasses) {
  for (const char* text :
       {"", " ", "{", "{}", "[1]", "7", "7\n", "{\"title\":\"a", "hello", "{\"a\\\"trace\":1}"}) {
    EXPECT_EQ(recognise_file(text).kind, FileKind::unknown) << text;
    EXPECT_NO_THROW(refuse_other_kinds(text, "file", "a scene", {FileKind::scene}));
  }
}

/// Cut anywhere, with bytes changed: never more than a word about it.
TEST(FileKind, SurvivesAnyBytes) {
  std::mt19937_64 random(3);
  const std::string scene = beginning_of(TPS_SOURCE_DIR "/data/scenes/pair.json");
  for (int n = 0; n < 2000; ++n) {
    std::string text = scene.substr(0, random() % scene.size());
    for (int k = 0; k < 3 && !text.empty(); ++k) text[random() % text.size()] = static_cast<char>(random());
    EXPECT_LT(recognise_file(text).what.size(), 100U);
  }
}

}  // namespace
}  // namespace tps
