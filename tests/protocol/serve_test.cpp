// The program itself: pipes, signals, exit codes.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/shell.hpp"

namespace {

using tps::Outcome;
using tps::run_shell;

const std::string kServe = TPS_PROGRAM " serve";

TEST(Serve, EndsWithTheInputOrAtBye) {
  EXPECT_EQ(run_shell(kServe + " < /dev/null").exit_code, 0);
  const Outcome bye = run_shell("printf '%s\\n' '{\"hello\":1}' '{\"bye\":1}' '{\"hello\":1}' | " + kServe);
  EXPECT_EQ(bye.exit_code, 0);
  EXPECT_EQ(bye.text.find("\"name\""), bye.text.rfind("\"name\""));
  EXPECT_NE(bye.text.find("\"name\""), std::string::npos);
}

// A client that sends one request and waits gets its reply: the second line is written only after the first
// reply.
TEST(Serve, RepliesBeforeItWaits) {
  const Outcome talk =
      run_shell("d=$(mktemp -d); mkfifo $d/in $d/out; " + kServe +
                " < $d/in > $d/out & exec 3> $d/in 4< $d/out; "
                "echo '{\"hello\":1}' >&3; read -r hello <&4; echo \"first $hello\"; "
                "echo '{\"seq\":1,\"op\":\"warp\",\"in\":{}}' >&3; read -r skip <&4; echo \"second $skip\"; "
                "exec 3>&-; wait $!; echo \"exit $?\"; rm -r $d");
  EXPECT_NE(talk.text.find("first {\"name\""), std::string::npos) << talk.text;
  EXPECT_NE(talk.text.find("second {\"seq\":1,\"skip\""), std::string::npos) << talk.text;
  EXPECT_NE(talk.text.find("exit 0"), std::string::npos) << talk.text;
}

TEST(Serve, SaysWhyItCannotRead) {
  const Outcome directory = run_shell(kServe + " < /");
  EXPECT_EQ(directory.exit_code, 3);
  EXPECT_NE(directory.text.find("standard input: cannot be read: Is a directory"), std::string::npos);
  EXPECT_EQ(run_shell(kServe + " <&-").exit_code, 3);
}

TEST(Serve, AReaderThatLeavesIsAnErrorOfWriting) {
  const Outcome gone =
      run_shell("(yes '{\"hello\":1}' | " + kServe + "; echo \"exit $?\" >&2) | head -n 1 > /dev/null");
  EXPECT_NE(gone.text.find("exit 7"), std::string::npos) << gone.text;
}

// Ctrl-C while waiting: what was asked has been answered, and the exit code says why it ended.
TEST(Serve, AnInterruptEndsTheWait) {
  const Outcome interrupted = run_shell(
      "d=$(mktemp -d); mkfifo $d/in $d/out; " + kServe +
      " < $d/in > $d/out & p=$!; exec 3> $d/in 4< $d/out; "
      "echo '{\"hello\":1}' >&3; read -r hello <&4; kill -TERM $p; wait $p; echo \"exit $?\"; rm -r $d");
  EXPECT_NE(interrupted.text.find("exit 130"), std::string::npos) << interrupted.text;
}

TEST(Serve, ALongLineIsAnsweredAndPassedOver) {
  const Outcome longer =
      run_shell("{ head -c 3000000 /dev/zero | tr '\\0' ' '; echo; echo '{\"hello\":1}'; } | " + kServe);
  EXPECT_EQ(longer.exit_code, 0);
  EXPECT_NE(longer.text.find("\"error\":\"line_too_long\""), std::string::npos);
  EXPECT_NE(longer.text.find("\"name\":\"tps\""), std::string::npos);
}

}  // namespace
