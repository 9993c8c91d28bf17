// Debug drawing of the engine.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Kind = EngineDrawing::Kind;
using Eigen::Vector3d;

TEST(DrawingTest, ShowsShapesContactsGripsAndForces) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row footbot = world.addFootbot(flatPose(2.0, 1.0));
  const Row prey = world.addPrey(0.1, 0.1, 2.215, 1.0, 100.0);
  EngineDrawing drawing;
  world.engine.draw(drawing);
  // three circles of a footbot and one prey: 32 lines around, 4 upright; a square: 8 and 4
  EXPECT_EQ(drawing.lines(Kind::kShape).size(), 4U * 36U + 12U);
  EXPECT_TRUE(drawing.lines(Kind::kJoint).empty());

  world.setGripper(footbot, true);
  world.step();
  world.drive(footbot, -0.1);
  world.step(5);
  drawing.clear();
  world.engine.draw(drawing);
  ASSERT_EQ(drawing.lines(Kind::kJoint).size(), 2U);
  EXPECT_NEAR((drawing.lines(Kind::kJoint)[0].first.head<2>() - world.pose(footbot).position.head<2>()).norm(), 0,
              1e-3);
  EXPECT_NEAR((drawing.lines(Kind::kJoint)[1].second.head<2>() - world.pose(prey).position.head<2>()).norm(), 0, 1e-3);
  // it pulls in vain, with the friction limit of the ground
  ASSERT_EQ(drawing.lines(Kind::kForce).size(), 2U);
  Vector3d force = Vector3d::Zero();
  for (const auto& [from, to] : drawing.lines(Kind::kForce)) {
    force += (to - from) / EngineDrawing::kMetresPerNewton;
  }
  EXPECT_NEAR(force.x(), -0.9 * 1.8 * kGravity, 0.2);
  EXPECT_NEAR(force.y(), 0.0, 0.2);
}

TEST(DrawingTest, ShowsContactsWhereTheyAre) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row footbot = world.addFootbot(flatPose(1.0, 1.0));
  world.addBlock({0.1, 2.0, 0.5}, {1.5, 1.0, 0.25});
  world.drive(footbot, 0.3);
  world.step(30);
  EngineDrawing drawing;
  world.engine.draw(drawing);
  ASSERT_FALSE(drawing.lines(Kind::kContact).empty());
  for (const auto& [from, to] : drawing.lines(Kind::kContact)) {
    EXPECT_NEAR(from.x(), 1.45, 3e-3);
    EXPECT_NEAR(std::abs((to - from).normalized().x()), 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
