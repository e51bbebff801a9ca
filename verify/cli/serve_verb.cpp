// tps serve
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>

#include "verify/cli/verbs.hpp"
#include "verify/protocol/answer.hpp"
#include "verify/protocol/serve.hpp"

namespace tps::cli {
namespace {

std::atomic<bool> told_to_stop{false};

extern "C" void note_stop(int) {
  told_to_stop.store(true);
}

/// The second signal ends the program at once.
void stop_at(int signal_number) {
  struct sigaction action = {};
  action.sa_handler = note_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(signal_number, &action, nullptr);
}

int serve() {
  stop_at(SIGINT);
  stop_at(SIGTERM);
  if (::isatty(STDIN_FILENO) == 1) {
    fmt::print(stderr,
               "tps: reading requests, one a line, such as {{\"hello\":1}}; {{\"bye\":1}} or Ctrl-D ends\n");
  }
  Output output("-");
  const protocol::ServeEnd end = protocol::serve(STDIN_FILENO, output, [] { return told_to_stop.load(); });
  output.close();
  return end == protocol::ServeEnd::interrupted ? kInterrupted : kDone;
}

}  // namespace

void add_serve(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "serve", "Answers requests on standard input, one a line, with certified values (docs/protocol.md).");
  verb->footer(fmt::format(R"(Operations: {}
All values are correctly rounded, where an answer is not flagged.
Example: echo '{{"seq":1,"op":"block_time","in":{{"u_A":[0,0],"u_B":[5,0],"v_A":[1,0],"v_B":[0,0],"L":1}}}}' | tps serve)",
                           fmt::join(protocol::operation_names(), ", ")));
  verb->callback([&exit_code] { exit_code = serve(); });
}

}  // namespace tps::cli
