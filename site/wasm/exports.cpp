// The facade for JavaScript: UTF-8 that ends with 0.
#include <emscripten.h>

#include <string>

#include "site/wasm/facade.hpp"

extern "C" {

/// The reply stays until the next call.
EMSCRIPTEN_KEEPALIVE const char* tps_answer(const char* request) {
  static std::string reply;
  reply = tps::web::answer(request);
  return reply.c_str();
}
}
