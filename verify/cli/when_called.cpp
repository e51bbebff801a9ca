#include "verify/cli/when_called.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tps::cli {

void make_when_called(CLI::App* verb, std::function<void(CLI::App*)> make) {
  static std::map<CLI::App*, std::vector<std::function<void(CLI::App*)>>> all;
  auto& makers = all[verb];
  makers.push_back(std::move(make));
  verb->preparse_callback([verb, &makers](std::size_t) {
    for (const auto& each : makers) each(verb);
    refuse_empty_values(*verb);
  });
}

void refuse_empty_values(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_expected_min() == 0 || option->get_positional()) continue;
    option->check(CLI::Validator(
        [](std::string& text) {
          return text.empty() ? std::string("is given an empty value; give one, or leave the option out")
                              : std::string();
        },
        ""));
  }
  for (CLI::App* verb : app.get_subcommands({})) refuse_empty_values(*verb);
}

}  // namespace tps::cli
