// tps serve
#include <fmt/format.h>
#include <unistd.h>

#include "reference/process/interrupt.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/protocol/answer.hpp"
#include "verify/protocol/serve.hpp"

namespace tps::cli {
namespace {

int serve() {
  NamedFiles().reads("requests", "-").require_distinct();
  const interrupt::GoodOrder good_order;
  if (::isatty(STDIN_FILENO) == 1) {
    say("tps: reading requests, one a line, such as {{\"hello\":1}}; {{\"bye\":1}} or Ctrl-D ends\n");
  }
  Output output("-");
  const protocol::ServeEnd end = protocol::serve(STDIN_FILENO, output, interrupt::requested);
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
