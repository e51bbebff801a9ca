// docs_snippets eqN: runs the example of docs/eqN.md. Its text between the markers is the page's code block.
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "docs/snippets/snippets.hpp"

int main(int argc, char** argv) {
  const std::map<std::string, std::function<void()>> snippets{
      {"eq1", tps::docs::eq1}, {"eq2", tps::docs::eq2}, {"eq3", tps::docs::eq3}, {"eq4", tps::docs::eq4},
      {"eq5", tps::docs::eq5}, {"eq6", tps::docs::eq6}, {"eq7", tps::docs::eq7}};
  const auto found = argc == 2 ? snippets.find(argv[1]) : snippets.end();
  if (found == snippets.end()) {
    std::cerr << "usage: docs_snippets eq1|eq2|eq3|eq4|eq5|eq6|eq7\n";
    return 2;
  }
  found->second();
  return 0;
}
