#include "properties/conform/made_ahead.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace tps::properties::conform {
namespace {

const std::function<std::string(std::size_t)> kName = [](std::size_t n) { return std::to_string(n); };

std::vector<std::string> used(std::size_t count, std::size_t until) {
  std::vector<std::string> all;
  for_each_made_ahead<std::string>(count, kName, [&](std::string item) {
    all.push_back(std::move(item));
    return all.size() < until;
  });
  return all;
}

TEST(MadeAhead, ItemsComeInOrderAndOnce) {
  EXPECT_EQ(used(0, 9), (std::vector<std::string>{}));
  EXPECT_EQ(used(5, 9), (std::vector<std::string>{"0", "1", "2", "3", "4"}));
}

TEST(MadeAhead, WhoeverHasEnoughEndsIt) {
  std::atomic<std::size_t> made = 0;
  for_each_made_ahead<std::size_t>(
      1000000, [&](std::size_t n) { return ++made, n; }, [](std::size_t n) { return n < 3; });
  EXPECT_LE(made, 8U);  // four used, two waiting, one in work
  EXPECT_EQ(used(1000000, 2).size(), 2U);
}

TEST(MadeAhead, WhatEitherThrowsArrivesAfterTheItemsBefore) {
  std::vector<std::size_t> seen;
  const auto third_fails = [](std::size_t n) {
    if (n == 2) throw std::runtime_error("the third");
    return n;
  };
  const auto see = [&](std::size_t n) { return seen.push_back(n), true; };
  EXPECT_THROW(for_each_made_ahead<std::size_t>(9, third_fails, see), std::runtime_error);
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1}));
  EXPECT_THROW(for_each_made_ahead<std::string>(
                   9, kName, [](const std::string&) -> bool { throw std::logic_error("no use"); }),
               std::logic_error);
}

/// Ctrl-C has to interrupt the waiting of the thread that asks.
TEST(MadeAhead, SignalsPassTheMakerBy) {
  const auto is_blocked = [](std::size_t) {
    sigset_t mask;
    pthread_sigmask(SIG_BLOCK, nullptr, &mask);
    return sigismember(&mask, SIGINT) == 1 && sigismember(&mask, SIGTERM) == 1;
  };
  for_each_made_ahead<bool>(2, is_blocked, [](bool blocked) {
    EXPECT_TRUE(blocked);
    return true;
  });
  EXPECT_FALSE(is_blocked(0));
}

/// A child is born between two steps: what the other thread was at is whole, and nobody holds the lock.
TEST(MadeAhead, AForkWaitsForAStepThatHasBegun) {
  std::atomic<int> first = 0, second = 0;
  int torn = 0, stuck = 0;
  const auto make = [&](std::size_t n) {
    for (int step = 0; step < 20; ++step) {
      const NoForkMeanwhile here;
      ++first;
      ::usleep(50);
      ++second;
    }
    return n;
  };
  for_each_made_ahead<std::size_t>(50, make, [&](std::size_t) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(20);
      const bool whole = first == second;
      { const NoForkMeanwhile free; }
      ::_exit(whole ? 0 : 1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    torn += WIFEXITED(status) && WEXITSTATUS(status) == 1 ? 1 : 0;
    stuck += WIFSIGNALED(status) ? 1 : 0;
    return true;
  });
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(stuck, 0);
}

}  // namespace
}  // namespace tps::properties::conform
