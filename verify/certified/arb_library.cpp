#include <dlfcn.h>

#include <string>

#include "reference/process/missing_library.hpp"
#include "verify/certified/arb_functions.hpp"

namespace tps::loaded {
namespace {

/// By the name that a linked program would ask for. It stays loaded.
void* library() {
  if (void* found = ::dlopen(TPS_ARB_SONAME, RTLD_LAZY | RTLD_LOCAL)) return found;
  throw MissingLibrary(
      std::string("cannot load Arb, which encloses responses: ") + ::dlerror() +
      "; install it (Debian's package libflint-arb2), or name its folder in LD_LIBRARY_PATH");
}

}  // namespace

void* address_of(const char* function) {
  static void* const arb = library();
  if (void* found = ::dlsym(arb, function)) return found;  // looks through FLINT, too, which Arb needs
  throw MissingLibrary(std::string(TPS_ARB_SONAME) + " and the libraries that it needs have no function " +
                       function + ": the program was built with another version of Arb");
}

}  // namespace tps::loaded
