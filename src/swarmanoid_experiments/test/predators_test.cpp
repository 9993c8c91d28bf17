// The installed experiment `predators`: what one robot makes of neighbours and prey, by hand; and the pattern of Spears
// et al. (2004), in which neighbours are as far from each other as the force says, from any start.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// A robot of which the test says what it sees and hears.
class OnePredator {
 public:
  OnePredator() {
    robot_.provideSensor(FootbotCamera::kType, &camera_);
    robot_.provideSensor(RangeAndBearingReceived::kType, &received_);
    robot_.provideActuator(FootbotWheels::kType, &wheels_);
    robot_.provideActuator(RangeAndBearing::kType, &transmitter);
    loadPluginLibrary("predators", {}, {});
    controller_ = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, "predators"));
    Configuration parameters("parameters", "", {});
    parameters.set("speed", "0.12");
    parameters.set("distance", "0.4");
    parameters.set("appetite", "0.1");
    controller_->init(robot_, parameters);
  }

  void hear(double range, double bearing) {
    messages_.push_back({static_cast<float>(range), static_cast<float>(bearing), 0.0F, {}});
    received_.messages = messages_;
    step();
  }
  void seePrey(double distance, double bearing) {
    blobs_ = {{colors::kRed, static_cast<float>(bearing), static_cast<float>(distance)}};
    camera_.blobs = blobs_;
    step();
  }
  void step() { controller_->step(kEpoch, std::chrono::milliseconds(100)); }

  double speed() const { return 0.5 * (wheels_.left + wheels_.right) * kRadius; }
  double turnRate() const { return (wheels_.right - wheels_.left) * kRadius / kSeparation; }

  RangeAndBearing transmitter;

 private:
  static constexpr double kRadius = 0.029;     // m, of the wheels
  static constexpr double kSeparation = 0.14;  // m

  FootbotWheels wheels_;
  Robot robot_{"robot", "footbot", 1};
  FootbotCamera camera_;
  RangeAndBearingReceived received_;
  std::vector<ColorBlob> blobs_;
  std::vector<RangeAndBearingMessage> messages_;
  std::shared_ptr<Controller> controller_;
};

TEST(PredatorsControllerTest, FollowsTheForceOfANeighbourAheadOrBackwards) {
  // s = 0.4 / 0.41: the force s^3 (1 - s^2) / 0.1859 is 0.2407, which is 0.4814 of that of full speed
  OnePredator ahead;
  ahead.hear(0.41, 0.2);
  EXPECT_NEAR(ahead.speed(), 0.12 * 0.4814 * std::cos(0.2), 1e-4);
  EXPECT_NEAR(ahead.turnRate(), 1.5 * 0.4814 * 0.2, 1e-3);
  EXPECT_TRUE(ahead.transmitter.sends) << "else nobody knows of it";
  // s = 0.4 / 0.39: the force is -0.3014; away from what is to the left of ahead is backwards
  OnePredator behind;
  behind.hear(0.39, 0.2);
  EXPECT_NEAR(behind.speed(), -0.12 * 0.6029 * std::cos(0.2), 1e-4);
  EXPECT_NEAR(behind.turnRate(), 1.5 * 0.6029 * 0.2, 1e-3);
}

TEST(PredatorsControllerTest, ARangeThatNoiseHasMadeZeroIsVeryNear) {
  OnePredator robot;
  robot.hear(0.0, 0.0);
  EXPECT_NEAR(robot.speed(), -0.12, 1e-9);
}

TEST(PredatorsControllerTest, ForcesReachAsFarAsTheFirstRowOfAHexagonalGrid) {
  OnePredator robot;
  robot.hear(0.601, 0.0);
  EXPECT_EQ(robot.speed(), 0.0);
  robot.hear(0.599, 0.0);
  EXPECT_NEAR(robot.speed(), 0.12, 1e-9);
}

TEST(PredatorsControllerTest, ThePreyAttractsFromFarAwayByItsShareOfTheStrongestForce) {
  OnePredator far, near;
  far.seePrey(4.0, -0.3);
  EXPECT_NEAR(far.speed(), 0.12 * 0.2 * std::cos(0.3), 1e-5) << "0.1 of 1, and 0.5 is full speed";
  EXPECT_NEAR(far.turnRate(), 1.5 * 0.2 * -0.3, 1e-4);
  near.seePrey(0.39, 0.0);
  EXPECT_NEAR(near.speed(), -0.12 * 0.6029, 1e-4) << "it repels as a neighbour does";
}

// All bounds of this test. In a grid at rest neighbours are at `distance`. The prey's pull presses the grid a little:
// by the slope of the force, 10.8 for each part of the distance, its 0.05 upon each of two outer rows, carried by two
// neighbours at 30 degrees to it, by 2 * 0.05 / (10.8 * 2 * cos 30) = 0.5 % on the whole, and by a few times that where
// it adds up.
constexpr double kPressed = 0.05;  // part of the distance by which the mean may be less
constexpr double kUnequal = 0.12;  // by which the farthest and the nearest neighbour may be off
constexpr std::uint64_t kSeeds = 5;

class PredatorsExperimentTest : public testing::TestWithParam<double> {};

TEST_P(PredatorsExperimentTest, NeighboursComeToTheDistanceOfTheForce) {
  const double distance = GetParam();
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const auto simulation =
        installed("predators", seed, {"controllers.pc.parameters.distance=" + numberText(distance)});
    simulation->tick();
    const double apart_at_first =
        metricOf(*simulation, "neighbour.greatest") - metricOf(*simulation, "neighbour.least");
    EXPECT_GT(apart_at_first, 2.0 * kUnequal * distance) << "they start at random";
    finish(*simulation);
    EXPECT_TRUE(simulation->failures().empty());
    EXPECT_GT(metricOf(*simulation, "neighbour.mean"), (1.0 - kPressed) * distance);
    EXPECT_LT(metricOf(*simulation, "neighbour.mean"), 1.01 * distance);
    EXPECT_GT(metricOf(*simulation, "neighbour.least"), (1.0 - kUnequal) * distance);
    EXPECT_LT(metricOf(*simulation, "neighbour.greatest"), (1.0 + kUnequal) * distance);
    EXPECT_NEAR(metricOf(*simulation, "prey_distance.least"), distance, kUnequal * distance)
        << "the prey is a point of the grid";
  }
}

INSTANTIATE_TEST_SUITE_P(Distances, PredatorsExperimentTest, testing::Values(0.4, 0.6),
                         [](const auto& distance) { return distance.param == 0.4 ? "near" : "far"; });

TEST(PredatorsExperimentTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*installed("predators", 4), 200);
  EXPECT_EQ(hashesOf(*installed("predators", 4, {}, 2), 200), expected) << "on two threads";
  EXPECT_NE(hashesOf(*installed("predators", 5), 200), expected) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
