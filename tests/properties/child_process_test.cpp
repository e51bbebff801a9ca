#include "properties/implementations/child_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <string>

namespace tps::properties {
namespace {

using Status = ChildProcess::Line::Status;
constexpr std::chrono::milliseconds kLong{20'000};

int echo() {
  std::string line;
  while (std::getline(std::cin, line)) std::cout << "<" << line << ">" << std::endl;
  return 0;
}

TEST(ChildProcess, TalksLineByLine) {
  ChildProcess child(echo);
  for (const char* text : {"one", "", "three"}) {
    ASSERT_TRUE(child.write_line(text));
    const ChildProcess::Line line = child.read_line(kLong);
    EXPECT_EQ(line.status, Status::line);
    EXPECT_EQ(line.text, std::string("<") + text + ">");
  }
}

TEST(ChildProcess, SaysHowItEnded) {
  ChildProcess exits([] { return 3; });
  const ChildProcess::Line ended = exits.read_line(kLong);
  EXPECT_EQ(ended.status, Status::ended);
  EXPECT_EQ(ended.text, "ended with exit code 3");
  ChildProcess crashes([]() -> int {
    std::signal(SIGABRT, SIG_DFL);
    std::raise(SIGABRT);
    return 0;
  });
  EXPECT_NE(crashes.read_line(kLong).text.find("crashed: signal 6"), std::string::npos);
  ChildProcess breaks_off([] {
    std::cout << "half" << std::flush;
    return 0;
  });
  EXPECT_EQ(breaks_off.read_line(kLong).text, "ended with exit code 0 in the middle of a line: half");
}

TEST(ChildProcess, DoesNotWaitForEver) {
  ChildProcess sleeps([] {
    ::pause();
    return 0;
  });
  EXPECT_EQ(sleeps.read_line(std::chrono::milliseconds(20)).status, Status::late);
}

TEST(ChildProcess, DoesNotReadForEver) {
  ChildProcess babbles([] {
    const std::string block(65536, 'x');
    while (std::cout << block) {
    }
    return 0;
  });
  EXPECT_EQ(babbles.read_line(kLong).status, Status::too_long);
}

}  // namespace
}  // namespace tps::properties
