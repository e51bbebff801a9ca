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
    child.write_line(text);
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

TEST(ChildProcess, TellsACrashFromAHangThoughADescendantHoldsThePipes) {
  ChildProcess crashes([]() -> int {
    if (::fork() == 0) ::pause();
    std::raise(SIGKILL);
    return 0;
  });
  const ChildProcess::Line line = crashes.read_line(kLong);
  EXPECT_EQ(line.status, Status::ended);
  EXPECT_EQ(line.code, 128 + SIGKILL);
}

TEST(ChildProcess, TakesARequestThatIsLongerThanThePipe) {
  const std::string text(std::size_t{1} << 19, 'x');
  ChildProcess child(echo);
  child.write_line(text);
  EXPECT_EQ(child.read_line(kLong).text, "<" + text + ">");
}

TEST(ChildProcess, DoesNotWaitForOneThatReadsNothing) {
  ChildProcess deaf([] {
    ::pause();
    return 0;
  });
  for (int n = 0; n < 100; ++n) deaf.write_line(std::string(65536, 'x'));
  EXPECT_EQ(deaf.read_line(std::chrono::milliseconds(20)).status, Status::late);
}

TEST(ChildProcess, KeepsTheLastWordsOnStandardError) {
  ChildProcess talks([] {
    for (int n = 0; n < 100'000; ++n) std::cerr << "noise " << n << "\n";
    std::cerr << "the reason\x1b[31m" << std::flush;
    return 2;
  });
  const std::string text = talks.read_line(kLong).text;
  EXPECT_NE(text.find("exit code 2; its last words on standard error: "), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("the reason?[31m")) << text;
  EXPECT_LT(text.size(), 500U);
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
