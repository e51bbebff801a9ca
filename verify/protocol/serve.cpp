#include "verify/protocol/serve.hpp"

#include "reference/text/line_reader.hpp"
#include "verify/protocol/conversation.hpp"

namespace tps::protocol {

ServeEnd serve(int input, Output& output, const std::function<bool()>& stop) {
  LineReader reader(
      "standard input", input, kLongestRequest, [&output] { output.flush(); }, stop);
  while (true) {
    const LineReader::Result line = reader.next();
    if (line.status == LineReader::Status::end) return ServeEnd::finished;
    if (line.status == LineReader::Status::interrupted) return ServeEnd::interrupted;
    const Reply reply =
        line.status == LineReader::Status::too_long ? reply_to_long_line(line.text) : reply_to(line.text);
    if (reply.last) return ServeEnd::finished;
    output.write(reply.text);
    output.write("\n");
  }
}

}  // namespace tps::protocol
