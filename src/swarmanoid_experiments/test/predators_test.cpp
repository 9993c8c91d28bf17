// The installed experiment `predators`: reactions of one robot to neighbours and prey, computed by hand; and the
// pattern of Spears et al. (2004), in which neighbours have the equilibrium distance of the force, from any start.
#include <gtest/gtest.h>

#include "installed_experiment.hpp"
#include "one_footbot.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

class OnePredator : public OneFootbot {
 public:
  OnePredator() : OneFootbot("predators", {{"speed", "0.12"}, {"distance", "0.4"}, {"appetite", "0.1"}}) {}

  void stepWithNeighbour(double range, double bearing) {
    hear(range, bearing);
    step();
  }
  void stepWithPrey(double distance, double bearing) {
    see(colors::kRed, distance, bearing);
    step();
  }
};

TEST(PredatorsControllerTest, FollowsTheForceOfANeighbourAheadOrBackwards) {
  // s = 0.4 / 0.41: the force s^3 (1 - s^2) / 0.1859 is 0.2407, which gives 0.4814 of full speed
  OnePredator ahead;
  ahead.stepWithNeighbour(0.41, 0.2);
  EXPECT_NEAR(ahead.wheels.speed(), 0.12 * 0.4814 * std::cos(0.2), 1e-4);
  EXPECT_NEAR(ahead.wheels.turnRate(), 1.5 * 0.4814 * 0.2, 1e-3);
  EXPECT_TRUE(ahead.transmitter.sends) << "neighbours must receive it";
  // s = 0.4 / 0.39: the force is -0.3014; the direction away from a neighbour ahead on the left is backwards
  OnePredator behind;
  behind.stepWithNeighbour(0.39, 0.2);
  EXPECT_NEAR(behind.wheels.speed(), -0.12 * 0.6029 * std::cos(0.2), 1e-4);
  EXPECT_NEAR(behind.wheels.turnRate(), 1.5 * 0.6029 * 0.2, 1e-3);
}

TEST(PredatorsControllerTest, ARangeThatNoiseHasMadeZeroIsVeryNear) {
  OnePredator robot;
  robot.stepWithNeighbour(0.0, 0.0);
  EXPECT_NEAR(robot.wheels.speed(), -0.12, 1e-9);
}

TEST(PredatorsControllerTest, ForcesReachAsFarAsTheFirstRowOfAHexagonalGrid) {
  OnePredator robot;
  robot.stepWithNeighbour(0.601, 0.0);
  EXPECT_EQ(robot.wheels.speed(), 0.0);
  robot.stepWithNeighbour(0.599, 0.0);
  EXPECT_NEAR(robot.wheels.speed(), 0.12, 1e-9);
}

TEST(PredatorsControllerTest, ThePreyAttractsFromFarAwayByItsShareOfTheStrongestForce) {
  OnePredator far, near;
  far.stepWithPrey(4.0, -0.3);
  EXPECT_NEAR(far.wheels.speed(), 0.12 * 0.2 * std::cos(0.3), 1e-5) << "0.1 of 1, and 0.5 is full speed";
  EXPECT_NEAR(far.wheels.turnRate(), 1.5 * 0.2 * -0.3, 1e-4);
  near.stepWithPrey(0.39, 0.0);
  EXPECT_NEAR(near.wheels.speed(), -0.12 * 0.6029, 1e-4) << "it repels as a neighbour does";
}

// Limits of this test. In a grid at rest neighbours have the distance `distance`. The prey's attraction compresses the
// grid slightly: its force of 0.05 on each of two outer rows is carried by two neighbours at 30 degrees, and the slope
// of the force is 10.8 per relative distance. This gives 2 * 0.05 / (10.8 * 2 * cos 30) = 0.5 % on average, and a few
// times that where the forces add up.
constexpr double kPressed = 0.05;  // maximum relative reduction of the mean distance
constexpr double kUnequal = 0.12;  // maximum relative deviation of the nearest and the farthest neighbour
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
