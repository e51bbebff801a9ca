// `tps check` as people call it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/content.hpp"
#include "tests/support/shell.hpp"

namespace tps {

inline const std::string kTps = TPS_PROGRAM;

/// A folder of its own for each test, with the trace of a small scene.
class Check : public testing::Test {
 protected:
  Check() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("tps_check_") + test->name() + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    run_shell(kTps + " run " TPS_SOURCE_DIR "/data/scenes/three-body.json -q -o " + file("good") +
              " > /dev/null");
  }
  ~Check() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(file(name)) << text; }
  Outcome check(const std::string& arguments) const { return run_shell(kTps + " check " + arguments); }

  /// The good trace with the first occurrence of a text behind `after` replaced.
  std::string broken(const std::string& after, const std::string& found, const std::string& instead) const {
    std::string text = content(file("good"));
    const std::size_t place = text.find(found, text.find(after));
    EXPECT_NE(place, std::string::npos);
    text.replace(place, found.size(), instead);
    return text;
  }
  /// Event 2 with its Δp the other way.
  void write_wrong_impulse() const { write("bad", broken("{\"k\":2,", "\"dp\":[\"-0x", "\"dp\":[\"0x")); }

 private:
  std::filesystem::path folder_;
};

inline void expect_text(const Outcome& outcome, const std::string& part) {
  EXPECT_NE(outcome.text.find(part), std::string::npos) << "looked for: " << part << "\nin: " << outcome.text;
}

}  // namespace tps
