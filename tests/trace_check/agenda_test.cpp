// An agenda names whoever began a flight, and whoever's time has come, and nobody else.
#include "verify/trace_check/agenda.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps::check {
namespace {

using List = std::vector<int>;

TEST(Agenda, BeginsWithEverybody) {
  Agenda agenda({2, 5, 3}, 7);
  EXPECT_EQ(agenda.due(0), (List{2, 3, 5}));
}

TEST(Agenda, NamesWhoseTimeHasCome) {
  Agenda agenda({1, 2, 3}, 4);
  for (const int i : agenda.due(0)) agenda.put_off(i, i);
  EXPECT_EQ(agenda.due(.5), List{});
  EXPECT_EQ(agenda.due(2), (List{1, 2}));
  agenda.put_off(1, HUGE_VAL);
  agenda.put_off(2, -HUGE_VAL);
  EXPECT_EQ(agenda.due(2.5), List{2});
  agenda.put_off(2, 9);
  EXPECT_EQ(agenda.due(8), List{3});
}

TEST(Agenda, NamesWhoBeganAnotherFlightOnce) {
  Agenda agenda({1, 2}, 4);
  for (const int i : agenda.due(0)) agenda.put_off(i, 5);
  agenda.begins_flight(2);
  agenda.begins_flight(2);
  agenda.begins_flight(3);  // no partner
  EXPECT_EQ(agenda.due(1), List{2});
  agenda.put_off(2, 7);
  EXPECT_EQ(agenda.due(6), List{1});  // the time of the flight before is void
  agenda.put_off(1, 8);
  EXPECT_EQ(agenda.due(7), List{2});
}

}  // namespace
}  // namespace tps::check
