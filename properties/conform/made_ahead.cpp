#include "properties/conform/made_ahead.hpp"

#include <pthread.h>

#include <new>

namespace tps::properties::conform {
namespace {

std::mutex& forks() {
  static std::mutex mutex;
  return mutex;
}

void lock_forks() {
  forks().lock();
}
void unlock_forks() {
  forks().unlock();
}

}  // namespace

NoForkMeanwhile::NoForkMeanwhile() {
  static const int refused = ::pthread_atfork(lock_forks, unlock_forks, unlock_forks);
  if (refused != 0) throw std::bad_alloc();
  forks().lock();
}

NoForkMeanwhile::~NoForkMeanwhile() {
  forks().unlock();
}

}  // namespace tps::properties::conform
