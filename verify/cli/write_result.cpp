#include "verify/cli/write_result.hpp"

#include "reference/text/output.hpp"

namespace tps::cli {

void write_result(const std::string& path, std::string_view text) {
  Output output(path);
  output.write(text);
  output.close();
}

}  // namespace tps::cli
