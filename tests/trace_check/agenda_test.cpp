// An agenda names whoever began a flight, and whoever's time has come, and nobody else.
#include "verify/trace_check/agenda.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tps::check {
namespace {

using List = std::vector<int>;

List due(Agenda& agenda, double t) {
  List partners;
  for (const Agenda::Due& each : agenda.due(t)) partners.push_back(each.partner);
  return partners;
}

TEST(Agenda, BeginsWithEverybody) {
  Agenda agenda({2, 5, 3}, 7);
  EXPECT_EQ(due(agenda, 0), (List{2, 3, 5}));
}

TEST(Agenda, NamesWhoseTimeHasCome) {
  Agenda agenda({1, 2, 3}, 4);
  for (const int i : due(agenda, 0)) agenda.put_off(i, i);
  EXPECT_EQ(due(agenda, .5), List{});
  EXPECT_EQ(due(agenda, 2), (List{1, 2}));
  agenda.put_off(1, HUGE_VAL);
  agenda.put_off(2, -HUGE_VAL);
  EXPECT_EQ(due(agenda, 2.5), List{2});
  agenda.put_off(2, 9);
  EXPECT_EQ(due(agenda, 8), List{3});
}

TEST(Agenda, NamesWhoBeganAnotherFlightOnce) {
  Agenda agenda({1, 2}, 4);
  for (const int i : due(agenda, 0)) agenda.put_off(i, 5);
  agenda.begins_flight(2);
  agenda.begins_flight(2);
  agenda.begins_flight(3);  // no partner
  EXPECT_EQ(due(agenda, 1), List{2});
  agenda.put_off(2, 7);
  EXPECT_EQ(due(agenda, 6), List{1});  // the time of the flight before is void
  agenda.put_off(1, 8);
  EXPECT_EQ(due(agenda, 7), List{2});
}

TEST(Agenda, SaysWhoWasPutOffRoughly) {
  Agenda agenda({1, 2}, 3);
  due(agenda, 0);
  agenda.put_off(1, 3, true);
  agenda.put_off(2, 3);
  const std::vector<Agenda::Due> first = agenda.due(3);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_TRUE(first[0].roughly);
  EXPECT_FALSE(first[1].roughly);
  agenda.put_off(1, 4, true);
  agenda.begins_flight(1);
  const std::vector<Agenda::Due> then = agenda.due(3.5);
  ASSERT_EQ(then.size(), 1U);
  EXPECT_FALSE(then[0].roughly);
}

}  // namespace
}  // namespace tps::check
