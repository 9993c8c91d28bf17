#include "swarmanoid_hosts/period_clock.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

using std::chrono::milliseconds;

TEST(PeriodClock, BeginsEachPeriodOnTheGrid) {
  PeriodClock clock(milliseconds(50), milliseconds(100));
  EXPECT_EQ(milliseconds(50), clock.next());
  EXPECT_EQ(1U, clock.begin(milliseconds(51)));
  EXPECT_EQ(milliseconds(150), clock.next());
  EXPECT_EQ(1U, clock.begin(milliseconds(249)));  // late, but in its period
  EXPECT_EQ(milliseconds(250), clock.next()) << "lateness does not add up";
  EXPECT_EQ(0U, clock.missed());
}

TEST(PeriodClock, LeavesMissedPeriodsOut) {
  PeriodClock clock(milliseconds(0), milliseconds(100));
  clock.begin(milliseconds(0));
  EXPECT_EQ(3U, clock.begin(milliseconds(350)));  // those of 100 and 200 are lost
  EXPECT_EQ(2U, clock.missed());
  EXPECT_EQ(milliseconds(400), clock.next());
  EXPECT_EQ(1U, clock.begin(milliseconds(400)));
  EXPECT_EQ(2U, clock.missed());
}

}  // namespace
}  // namespace swarmanoid
