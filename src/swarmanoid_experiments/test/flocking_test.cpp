// The installed experiment `flocking`: reactions of one robot to messages, computed by hand; and the papers' result
// that the order of the flock falls with the noise of headings.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "one_footbot.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot of a flock, with a lamp.
class OneRobot : public OneFootbot {
 public:
  explicit OneRobot(const char* alignment = "true")
      : OneFootbot("flocking",
                   {{"speed", "0.12"}, {"distance", "0.6"}, {"cohesion", "0.7"}, {"alignment", alignment}}) {}

  void hearRobot(const OneRobot& other, double range, double bearing) {
    hear(range, bearing, other.transmitter.payload);
  }
  void stepWithLamp(double bearing) {
    see(colors::kWhite, 90.0, bearing);
    step();
  }
};

TEST(FlockingControllerTest, TurnsToTheMeanOfTheHeadingsOfItsNeighbours) {
  // headings relative to the lamp: 0.4 and 1.6, and its own is -0.3; at the equilibrium distance the force is zero
  OneRobot one, two, robot;
  one.stepWithLamp(-0.4);
  two.stepWithLamp(-1.6);
  robot.hearRobot(one, 0.6, 2.0);
  robot.hearRobot(two, 0.6, -1.1);
  robot.stepWithLamp(0.3);
  EXPECT_NEAR(robot.wheels.turnRate(), 1.0 + 0.3, 1e-4) << "1/s times the angle to the mean heading, 1";
  EXPECT_NEAR(robot.wheels.speed(), 0.12 * std::cos(1.3), 1e-5);
}

TEST(FlockingControllerTest, GoesRoundAsAnglesDo) {
  OneRobot one, robot;
  one.stepWithLamp(-3.0);  // its heading is 3
  robot.hearRobot(one, 0.6, 0.0);
  robot.stepWithLamp(3.1);  // and that of this robot is -3.1
  EXPECT_NEAR(robot.wheels.turnRate(), 6.1 - 2.0 * M_PI, 1e-4);
}

TEST(FlockingControllerTest, ComesNearerToWhoIsFarAndLeavesWhoIsNear) {
  OneRobot other, far, near;
  other.stepWithLamp(0.0);
  // s = 0.6 / 0.9: the force s^3 (1 - s^2) / 0.1859 is 0.8855 to the left, in addition to the heading ahead
  far.hearRobot(other, 0.9, 0.5 * M_PI);
  far.stepWithLamp(0.0);
  EXPECT_NEAR(far.wheels.turnRate(), std::atan(0.7 * 0.8855), 1e-4);
  // s = 1.2: the force is -4.0898
  near.hearRobot(other, 0.5, 0.5 * M_PI);
  near.stepWithLamp(0.0);
  EXPECT_NEAR(near.wheels.turnRate(), -std::atan(0.7 * 4.0898), 1e-4);
}

TEST(FlockingControllerTest, WithoutAlignmentHeadingsDoNotMatterAndWithoutLampItIsSilent) {
  OneRobot other, robot("false");
  other.stepWithLamp(-1.0);
  robot.hearRobot(other, 0.6, 1.0);
  robot.stepWithLamp(0.0);
  EXPECT_NEAR(robot.wheels.turnRate(), 0.0, 1e-6);
  EXPECT_TRUE(robot.transmitter.sends);
  OneRobot blind;
  blind.hearRobot(other, 0.6, 1.0);
  blind.step();
  EXPECT_NEAR(blind.wheels.turnRate(), 0.0, 1e-6);
  EXPECT_FALSE(blind.transmitter.sends);
}

double meanOrder(std::uint64_t seed, const std::string& override) {
  const auto simulation = installed("flocking", seed, {override});
  finish(*simulation);
  EXPECT_TRUE(simulation->failures().empty());
  return metricOf(*simulation, "flock.mean_order");
}

const std::string kNoise = "controllers.fc.sensors.footbot_camera.heading_noise.half_width=";

TEST(FlockingExperimentTest, TheOrderFallsWithTheNoiseOfHeadings) {
  // a single noisy flock may have as little order as one without alignment, so means are compared
  constexpr int kSeeds = 4;
  double noisy = 0.0;
  double random = 0.0;
  for (std::uint64_t seed = 21; seed < 21 + kSeeds; ++seed) {
    const double much = meanOrder(seed, kNoise + "2.6");
    const double all = meanOrder(seed, kNoise + "3.14");
    EXPECT_GT(meanOrder(seed, kNoise + "0.5"), 0.95) << "seed " << seed;
    EXPECT_LT(much, 0.9) << "seed " << seed;
    EXPECT_LT(all, 0.5) << "seed " << seed;
    noisy += much / kSeeds;
    random += all / kSeeds;
  }
  EXPECT_GT(noisy, random + 0.05);
}

TEST(FlockingExperimentTest, WithoutAlignmentThereIsNoOrder) {
  for (std::uint64_t seed = 21; seed <= 23; ++seed) {
    EXPECT_LT(meanOrder(seed, "controllers.fc.parameters.alignment=false"), 0.5) << "seed " << seed;
  }
}

TEST(FlockingExperimentTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*installed("flocking", 4), 300);
  EXPECT_EQ(hashesOf(*installed("flocking", 4, {}, 2), 300), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("flocking", 5), 300), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
