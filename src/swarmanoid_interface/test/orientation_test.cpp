#include "swarmanoid_interface/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace swarmanoid {
namespace {

TEST(OrientationTest, AnglesAreTurnsAboutXThenYThenZ) {
  const double half = M_PI / 2.0;
  const Eigen::Quaterniond turn = orientationFromAngles({half, 0.0, half});
  // ahead: x stays under the turn about x, then goes to y; left: y goes to z, and stays there
  EXPECT_LT((turn * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_LT((turn * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(OrientationTest, AnglesComeBackFromTheOrientation) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> full(-M_PI, M_PI);
  std::uniform_real_distribution<double> half(-1.57, 1.57);
  for (int i = 0; i < 10000; ++i) {
    const Eigen::Vector3d angles(full(random), half(random), full(random));
    EXPECT_LT((anglesFromOrientation(orientationFromAngles(angles)) - angles).norm(), 1e-9);
  }
}

TEST(OrientationTest, UprightBeyondTheVerticalGivesAnglesOfTheSameOrientation) {
  for (const double beta : {M_PI / 2.0, -M_PI / 2.0}) {
    const Eigen::Quaterniond before = orientationFromAngles({0.3, beta, 0.5});
    const Eigen::Vector3d angles = anglesFromOrientation(before);
    EXPECT_NEAR(angles.y(), beta, 1e-7);
    EXPECT_LT(orientationFromAngles(angles).angularDistance(before), 1e-6);
  }
}

}  // namespace
}  // namespace swarmanoid
