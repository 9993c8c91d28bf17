// Simulated time is epoch + tick * clocktick, to the nanosecond, without limit.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/testing/small_world.hpp"

namespace swarmanoid {
namespace {

using std::chrono::nanoseconds;

void tickTo(Simulation& simulation, std::uint64_t tick) {
  while (simulation.space().tick < tick) {
    simulation.tick();
  }
}

TEST(ClockTest, StartsAtTheEpochBecauseRosTakesZeroForUnset) {
  const auto simulation = test::smallWorld();
  EXPECT_EQ(simulation->space().tick, 0U);
  EXPECT_EQ(simulation->space().time, Time(std::chrono::seconds(1)));
  EXPECT_EQ(toSeconds(simulation->space().time), 1.0);
}

TEST(ClockTest, DoesNotDriftInAMillionTicks) {
  // a third of a second has no exact binary fraction; the file gives it to the nanosecond
  const auto simulation = test::smallWorld(2'000'000, "333.333333");
  simulation->start();
  for (const std::uint64_t tick : {1ULL, 1000ULL, 1'000'000ULL}) {
    tickTo(*simulation, tick);
    EXPECT_EQ(simulation->space().time, kEpoch + nanoseconds(333333333) * tick);
  }
}

TEST(ClockTest, TicksAreAsLongAsTheFileSays) {
  for (const auto& [text, length] : {std::pair("100", 100'000'000), std::pair("0.001", 1'000),
                                     std::pair("16.6666667", 16'666'667), std::pair("1e3", 1'000'000'000)}) {
    const auto simulation = test::smallWorld(10, text);
    simulation->start();
    tickTo(*simulation, 3);
    EXPECT_EQ(simulation->space().time - kEpoch, nanoseconds(3LL * length)) << text << " ms";
  }
}

TEST(ClockTest, StopsAtMaxclock) {
  const auto simulation = test::smallWorld(5);
  simulation->start();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(simulation->isFinished(), i >= 5);
    simulation->tick();
  }
  EXPECT_EQ(simulation->space().tick, 5U);
  EXPECT_EQ(simulation->space().time, kEpoch + std::chrono::milliseconds(500));
}

TEST(ClockTest, AResetPutsTheSpaceBackButNotRosTime) {
  const auto simulation = test::smallWorld(100);
  simulation->start();
  tickTo(*simulation, 7);
  const Space& space = simulation->space();
  const Time last = space.time + space.time_before_reset;
  simulation->reset();
  EXPECT_EQ(space.tick, 0U);
  EXPECT_EQ(space.time, kEpoch);
  EXPECT_EQ(space.time + space.time_before_reset, last + space.clocktick);
  tickTo(*simulation, 3);
  simulation->reset(std::nullopt, true);
  EXPECT_EQ(space.time + space.time_before_reset, kEpoch);
  EXPECT_EQ(space.run, 2U);
}

}  // namespace
}  // namespace swarmanoid
