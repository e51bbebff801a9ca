// The facade as a program: a request a line, a reply a line. The tests of the WebAssembly build compare the
// two.
#include <iostream>
#include <string>

#include "site/wasm/facade.hpp"

int main() {
  std::ios::sync_with_stdio(false);
  for (std::string line; std::getline(std::cin, line);) std::cout << tps::web::answer(line) << '\n';
}
