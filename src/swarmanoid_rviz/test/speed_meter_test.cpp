#include "../src/speed_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swarmanoid {
namespace {

/// Simulated time that a sample sees at that speed, in whole ticks of 0.1 s.
double wholeTicks(double real, double speed) { return 0.1 * std::floor(real * speed / 0.1 + 1e-9); }

TEST(SpeedMeterTest, TicksThatAreWholeDoNotMakeItWaver) {
  SpeedMeter meter;
  EXPECT_EQ(0.0, meter.look(100.0, 7.0)) << "one look is none";
  for (int i = 1; i < 200; ++i) {
    const double real = 0.207 * i;
    const double speed = meter.look(100.0 + real, 7.0 + wholeTicks(real, 1.3));
    if (real > 5.3) {
      EXPECT_NEAR(1.3, speed, 0.1 / 5.0 + 1e-9) << "at " << real << " s";
    }
  }
}

TEST(SpeedMeterTest, ItFollowsAnotherSpeedWithinSecondsAndForgetsAtARestart) {
  SpeedMeter meter;
  double simulated = 0.0;
  double real = 0.0;
  double speed = 0.0;
  for (; real < 20.0; real += 0.25, simulated += 0.25) {
    speed = meter.look(real, simulated);
  }
  EXPECT_NEAR(1.0, speed, 1e-9);
  for (; real < 25.5; real += 0.25, simulated += 1.0) {
    speed = meter.look(real, simulated);
  }
  EXPECT_NEAR(4.0, speed, 1e-9);
  meter.restart();
  EXPECT_EQ(0.0, meter.look(real, 0.0));
  EXPECT_NEAR(2.0, meter.look(real + 0.5, 1.0), 1e-9);
  EXPECT_EQ(0.0, meter.look(real + 1.0, 0.9)) << "time went back: a reset";
}

}  // namespace
}  // namespace swarmanoid
