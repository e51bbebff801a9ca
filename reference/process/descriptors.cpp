#include "reference/process/descriptors.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace tps {
namespace {

void occupy(int descriptor, int mode) {
  if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) return;
  const int opened = ::open("/dev/null", mode);  // the lowest number that is free
  if (opened == descriptor || opened < 0) return;
  ::dup2(opened, descriptor);
  ::close(opened);
}

}  // namespace

void occupy_standard_descriptors() {
  occupy(STDIN_FILENO, O_WRONLY);
  occupy(STDOUT_FILENO, O_RDONLY);
  occupy(STDERR_FILENO, O_WRONLY);
}

}  // namespace tps
