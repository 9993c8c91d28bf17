// The installed experiment `flocking`: what one robot makes of what it hears, by hand; and the figure of the papers,
// that the order of the flock falls as the noise of headings grows.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr auto kTick = std::chrono::milliseconds(100);

/// A robot of which the test says what it sees and hears.
class OneRobot {
 public:
  explicit OneRobot(const char* alignment = "true") {
    robot_.provideSensor(FootbotCamera::kType, &camera_);
    robot_.provideSensor(RangeAndBearingReceived::kType, &received_);
    robot_.provideActuator(FootbotWheels::kType, &wheels);
    robot_.provideActuator(RangeAndBearing::kType, &transmitter);
    loadPluginLibrary("flocking", {}, {});
    controller_ = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, "flocking"));
    Configuration parameters("parameters", "", {});
    parameters.set("speed", "0.12");
    parameters.set("distance", "0.6");
    parameters.set("cohesion", "0.7");
    parameters.set("alignment", alignment);
    controller_->init(robot_, parameters);
  }

  /// Another robot at that place says what `other` says.
  void hear(const OneRobot& other, float range, float bearing) {
    messages_.push_back({range, bearing, 0.0F, other.transmitter.payload});
  }
  void step(double lamp_bearing) {
    blobs_ = {{colors::kWhite, static_cast<float>(lamp_bearing), 90.0F}};
    stepInTheDark();
  }
  void stepInTheDark() {
    camera_.blobs = blobs_;
    received_.messages = messages_;
    controller_->step(kEpoch, kTick);
  }

  double turnRate() const { return (wheels.right - wheels.left) * kRadius / kSeparation; }
  double speed() const { return 0.5 * (wheels.left + wheels.right) * kRadius; }

  FootbotWheels wheels;
  RangeAndBearing transmitter;

 private:
  static constexpr double kRadius = 0.029;     // m, of the wheels
  static constexpr double kSeparation = 0.14;  // m

  Robot robot_{"robot", "footbot", 1};
  FootbotCamera camera_;
  RangeAndBearingReceived received_;
  std::vector<ColorBlob> blobs_;
  std::vector<RangeAndBearingMessage> messages_;
  std::shared_ptr<Controller> controller_;
};

TEST(FlockingControllerTest, TurnsToTheMeanOfTheHeadingsOfItsNeighbours) {
  // headings are those against the lamp: 0.4 and 1.6, and its own is -0.3; at the wanted distance there is no force
  OneRobot one, two, robot;
  one.step(-0.4);
  two.step(-1.6);
  robot.hear(one, 0.6F, 2.0F);
  robot.hear(two, 0.6F, -1.1F);
  robot.step(0.3);
  EXPECT_NEAR(robot.turnRate(), 1.0 + 0.3, 1e-4) << "1/s times the angle to the mean heading, 1";
  EXPECT_NEAR(robot.speed(), 0.12 * std::cos(1.3), 1e-5);
}

TEST(FlockingControllerTest, GoesRoundAsAnglesDo) {
  OneRobot one, robot;
  one.step(-3.0);  // its heading is 3
  robot.hear(one, 0.6F, 0.0F);
  robot.step(3.1);  // and that of this one -3.1
  EXPECT_NEAR(robot.turnRate(), 6.1 - 2.0 * M_PI, 1e-4);
}

TEST(FlockingControllerTest, ComesNearerToWhoIsFarAndLeavesWhoIsNear) {
  OneRobot other, far, near;
  other.step(0.0);
  // s = 0.6 / 0.9: the force s^3 (1 - s^2) / 0.1859 is 0.8855 to the left, beside the heading ahead
  far.hear(other, 0.9F, static_cast<float>(0.5 * M_PI));
  far.step(0.0);
  EXPECT_NEAR(far.turnRate(), std::atan(0.7 * 0.8855), 1e-4);
  // s = 1.2: the force is -4.0898
  near.hear(other, 0.5F, static_cast<float>(0.5 * M_PI));
  near.step(0.0);
  EXPECT_NEAR(near.turnRate(), -std::atan(0.7 * 4.0898), 1e-4);
}

TEST(FlockingControllerTest, WithoutAlignmentHeadingsDoNotMatterAndWithoutLampItIsSilent) {
  OneRobot other, robot("false");
  other.step(-1.0);
  robot.hear(other, 0.6F, 1.0F);
  robot.step(0.0);
  EXPECT_NEAR(robot.turnRate(), 0.0, 1e-6);
  EXPECT_TRUE(robot.transmitter.sends);
  OneRobot blind;
  blind.hear(other, 0.6F, 1.0F);
  blind.stepInTheDark();
  EXPECT_NEAR(blind.turnRate(), 0.0, 1e-6);
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
  // a single flock with much noise may have as little order as one without headings: so their means are compared
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
