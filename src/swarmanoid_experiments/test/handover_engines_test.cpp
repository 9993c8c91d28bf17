// A footbot that grips a prey is handed over, in motion, through all engines that support both.
#include <gtest/gtest.h>

#include <array>

#include "handover_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr std::array<const char*, 3> kEngines = {"ground", "forces", "space"};

/// All engines in one world; the footbot grips the prey in the first ticks and drives an arc.
/// @param place of the footbot, along x and along y [m]; @param drive parameters of the controller
std::unique_ptr<Simulation> worldOfThreeEngines(double place = 5.0,
                                                const std::string& drive = "<left>2</left><right>3</right>") {
  World world = carrierWorld();
  world.size = "100,100,2";
  world.entities = footbot("fb", place, place, 90) + prey("prey", place, place + 0.171);
  world.drive = drive + "<close_at>0</close_at>";
  world.engines =
      "<dynamics2d id='forces'><subclock>10</subclock></dynamics2d>"
      "<dynamics3d id='space'><subclock>10</subclock></dynamics3d>";
  return started(world);
}

struct State {
  Pose pose;
  Twist twist;
};

State stateOf(const Simulation& simulation, const char* name) {
  return {poseOf(simulation, name), twistOf(simulation, name)};
}

/// Hands the footbot over after each tick. @return the hashes
std::vector<std::uint64_t> carry(Simulation& simulation, int handovers) {
  std::vector<std::uint64_t> hashes;
  const Space& space = simulation.space();
  tick(simulation, 3);
  for (int i = 0; i < handovers; ++i) {
    simulation.tick();
    const State footbot = stateOf(simulation, "fb");
    const State prey = stateOf(simulation, "prey");
    const char* next = kEngines[static_cast<std::size_t>(i + 1) % kEngines.size()];
    simulation.apply(HandOverEntity{"fb", next});
    EXPECT_EQ(moverOf(simulation, "fb"), next);
    EXPECT_EQ(moverOf(simulation, "prey"), next);
    for (const auto& [name, before] : {std::pair("fb", footbot), std::pair("prey", prey)}) {
      const State after = stateOf(simulation, name);
      EXPECT_EQ(after.pose.position, before.pose.position) << name << ", handover " << i;
      EXPECT_EQ(after.pose.orientation.coeffs(), before.pose.orientation.coeffs()) << name << ", handover " << i;
      EXPECT_EQ(after.twist.linear, before.twist.linear) << name << ", handover " << i;
      EXPECT_EQ(after.twist.angular, before.twist.angular) << name << ", handover " << i;
    }
    hashes.push_back(simulation.stateHash());
    if (testing::Test::HasFailure() ||
        space.structure.grippedBy(space.entities.find("fb")) != space.entities.find("prey")) {
      ADD_FAILURE() << "handover " << i;
      break;
    }
  }
  return hashes;
}

class HandoverPlaceTest : public testing::TestWithParam<double> {};

TEST_P(HandoverPlaceTest, StateIsKeptFarFromTheOrigin) {
  auto simulation = worldOfThreeEngines(GetParam());
  carry(*simulation, 60);
}

TEST_P(HandoverPlaceTest, WhoStandsStaysWhereItIs) {
  auto simulation = worldOfThreeEngines(GetParam(), "<left>0</left><right>0</right>");
  tick(*simulation, 3);
  const State before = stateOf(*simulation, "fb");
  for (int i = 0; i < 50; ++i) {
    simulation->apply(HandOverEntity{"fb", i % 2 == 0 ? "forces" : "ground"});
    tick(*simulation, 2);
    const State after = stateOf(*simulation, "fb");
    ASSERT_LT((after.pose.position - before.pose.position).norm(), 2e-6) << "handover " << i;
    ASSERT_LT(after.pose.orientation.angularDistance(before.pose.orientation), 2e-6) << "handover " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Metres, HandoverPlaceTest, testing::Values(0.0, 10.0, 50.0));

TEST(HandoverEnginesTest, AThousandHandoversKeepStateGripAndCourse) {
  auto simulation = worldOfThreeEngines();
  tick(*simulation, 3);
  const double apart = (poseOf(*simulation, "fb").position - poseOf(*simulation, "prey").position).norm();
  const auto hashes = carry(*simulation, 1000);
  const auto& footbot = poseOf(*simulation, "fb");
  EXPECT_NEAR((footbot.position - poseOf(*simulation, "prey").position).norm(), apart, 2e-3);
  EXPECT_NEAR(footbot.position.z(), 0.0, 1e-3);
  EXPECT_GT((footbot.orientation * Eigen::Vector3d::UnitZ()).z(), std::cos(0.5 * M_PI / 180.0));
  // the same commands in the kinematic engine alone: 7.3 m and 3 1/3 turns
  auto alone = worldOfThreeEngines();
  tick(*alone, 1006);
  EXPECT_NEAR((footbot.position - poseOf(*alone, "fb").position).norm(), 0.0, 0.05);
  EXPECT_NEAR(footbot.orientation.angularDistance(poseOf(*alone, "fb").orientation), 0.0, 0.1);
  auto again = worldOfThreeEngines();
  tick(*again, 3);
  EXPECT_EQ(carry(*again, 1000), hashes);
}

}  // namespace
}  // namespace swarmanoid::test
