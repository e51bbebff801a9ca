// Replays the seeds of every target, and damaged versions of them: the part of fuzzing that every test run
// does.
//
// fuzz_replay CORPUS DICTIONARY DAMAGES [TARGET [FILE]…]
#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "tests/fuzz/damage.hpp"
#include "tests/fuzz/targets.hpp"

namespace {

using tps::fuzz::Target;

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The words of a libFuzzer dictionary: name="…" with \\, \" and \xHH.
std::vector<std::string> words_of(const std::string& path) {
  std::vector<std::string> words;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const std::size_t begin = line.find('"');
    const std::size_t end = line.rfind('"');
    if (line.starts_with('#') || begin == end) continue;
    std::string word;
    for (std::size_t k = begin + 1; k < end; ++k) {
      if (line[k] != '\\') {
        word += line[k];
      } else if (line[++k] == 'x') {
        word += static_cast<char>(std::stoi(line.substr(k + 1, 2), nullptr, 16));
        k += 2;
      } else {
        word += line[k];
      }
    }
    words.push_back(word);
  }
  return words;
}

/// False, and a file with the bytes, where the target broke a promise.
bool holds(const Target& target, const std::string& bytes, const std::string& what) {
  try {
    target.feed(bytes);
    return true;
  } catch (const std::exception& error) {
    const std::string kept = "fuzz_" + std::string(target.name) + ".failed";
    std::ofstream(kept, std::ios::binary) << bytes;
    std::cerr << target.name << ", " << what << ": " << error.what() << "\nthe bytes are in " << kept << "\n";
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: fuzz_replay CORPUS DICTIONARY DAMAGES [TARGET [FILE]...]\n";
    return 2;
  }
  const std::vector<std::string> words = words_of(argv[2]);
  const unsigned long damages = std::stoul(argv[3]);
  const std::string only = argc > 4 ? argv[4] : "";
  std::size_t fed = 0;
  bool good = true;
  for (const Target& target : tps::fuzz::targets()) {
    if (!only.empty() && target.name != only) continue;
    std::vector<std::filesystem::path> seeds;
    for (int n = 5; n < argc; ++n) seeds.emplace_back(argv[n]);
    if (seeds.empty()) {
      for (const auto& file :
           std::filesystem::directory_iterator(std::filesystem::path(argv[1]) / target.name))
        seeds.push_back(file.path());
      std::sort(seeds.begin(), seeds.end());
    }
    if (seeds.empty()) {
      std::cerr << target.name << " has no seeds\n";
      return 1;
    }
    std::mt19937_64 random(20'261'125);
    for (const std::filesystem::path& seed : seeds) {
      const std::string bytes = bytes_of(seed);
      good = holds(target, bytes, seed.string()) && good;
      ++fed;
    }
    for (unsigned long n = 0; n < damages; ++n, ++fed) {
      const std::filesystem::path& seed = seeds[n % seeds.size()];
      good = holds(target, tps::fuzz::damaged(bytes_of(seed), words, random),
                   seed.string() + ", damage " + std::to_string(n)) &&
             good;
    }
  }
  std::cout << fed << " inputs\n";
  return good ? 0 : 1;
}
