// Wheels and bodies as in robot descriptions: lying cylinders and boxes, turned by nearly a right angle or by any
// angle. Whatever their projection to the plane, no assertion of Box2D is reached, and contacts are as exact as
// elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>

#include "../exact_overlap.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Numbers as people and programs write them into descriptions.
class Descriptions {
 public:
  explicit Descriptions(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  /// A multiple of a right angle, written with some number of digits, or any angle [rad].
  double angle() {
    if (random_() % 4 == 0) {
      return between(-M_PI, M_PI);
    }
    const double exact = 0.5 * M_PI * (static_cast<double>(random_() % 5) - 2.0);
    const double digits = std::pow(10.0, static_cast<double>(random_() % 16));
    return random_() % 3 == 0 ? exact : std::round(exact * digits) / digits;
  }
  std::shared_ptr<const EntityModel> robot() {
    auto model = std::make_shared<EntityModel>(*footbotModel());
    model->type = "random";
    model->shapes.resize(1);  // the body
    const int wheels = 1 + static_cast<int>(random_() % 3);
    for (int i = 0; i < wheels; ++i) {
      const Eigen::Quaterniond turn = Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(angle(), Eigen::Vector3d::UnitZ());
      const bool is_box = random_() % 4 == 0;
      const double radius = between(0.01, 0.06);
      const Eigen::Vector3d half(radius, is_box ? between(0.004, 0.06) : radius, between(0.004, 0.03));
      model->shapes.push_back({is_box ? CollisionShape::Kind::kBox : CollisionShape::Kind::kCylinder,
                               half,
                               {between(-0.08, 0.08), between(-0.08, 0.08), 0.08},
                               turn});
    }
    model->measureShapes();
    return model;
  }
  std::shared_ptr<const EntityModel> block() {
    return blockModel({between(0.02, 0.3), between(0.02, 0.3), 0.3}, random_() % 2 == 0 ? 0.0 : between(0.2, 3.0));
  }

 private:
  std::mt19937 random_;
};

TEST(RandomWheelsTest, MeetBlocksWithoutAnAssertion) {
  constexpr double kMostOverlap = 6e-4;  // m
  const int count = std::getenv("SWARMANOID_LONG_TESTS") != nullptr ? 100'000 : 10'000;
  Descriptions random(17);
  int met = 0;
  for (int i = 0; i < count; ++i) {
    World world({6.0, 6.0, 2.0}, 1 + i % 3);
    const double heading = random.angle();
    const Row block = world.add(random.block(), flatPose(3.0, 3.0, random.angle(), 0.15));
    const Pose start = flatPose(3.0 - 0.42 * std::cos(heading), 3.0 - 0.42 * std::sin(heading), heading);
    const Row robot = world.addRobot(random.robot(), start);
    if (overlapOf(world.space, robot, block) > 0.0) {
      continue;  // the space would refuse it
    }
    world.drive(robot, 0.3, random.between(-0.5, 0.5));
    world.step(9);
    const Pose& end = world.pose(robot);
    ASSERT_TRUE(end.position.allFinite() && end.orientation.coeffs().allFinite()) << i;
    ASSERT_LT((end.position - start.position).norm(), 0.3) << i;
    ASSERT_LT(overlapOf(world.space, robot, block), kMostOverlap) << i;
    met += (end.position - start.position).norm() < 0.25 || world.twist(block).linear.norm() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(met, count / 2);
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
