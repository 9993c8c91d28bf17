// A crowd of footbots squeezed together: nothing overlaps, ever, and the same run gives the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::Vector2d;

constexpr double kAllowedDepth = 2e-9;  // m: the engine's tolerance and rounding

/// Depth of overlap of two footbots; below 0: they are apart. Written independently of the engine: from the poses in
/// the space, the shapes of figure 3.9, and Minkowski sums.
class FootbotDepth {
 public:
  explicit FootbotDepth(const Pose& pose)
      : centre_(pose.position.head<2>()), ahead_((pose.orientation * Eigen::Vector3d::UnitX()).head<2>()) {
    circles_ = {{centre_, 0.085}, {centre_ + 0.07 * left(), 0.018}, {centre_ - 0.07 * left(), 0.018}};
    square_centre_ = centre_ + 0.09 * ahead_;
  }

  double depthIn(const FootbotDepth& other) const {
    if ((centre_ - other.centre_).norm() > 0.23) {
      return -1.0;
    }
    double deepest = squaresDepth(other);
    for (const Circle& circle : circles_) {
      for (const Circle& other_circle : other.circles_) {
        deepest = std::max(deepest, circle.radius + other_circle.radius - (circle.centre - other_circle.centre).norm());
      }
      // the wheels' heights, 0 to 5.8 cm, overlap the gripper's, 3.5 to 6.5 cm
      deepest = std::max(deepest, other.squareDepth(circle));
    }
    for (const Circle& other_circle : other.circles_) {
      deepest = std::max(deepest, squareDepth(other_circle));
    }
    return deepest;
  }

 private:
  struct Circle {
    Vector2d centre;
    double radius;
  };

  static constexpr double kHalf = 0.02;  // m, of the square

  Vector2d left() const { return {-ahead_.y(), ahead_.x()}; }

  double squareDepth(const Circle& circle) const {
    const Vector2d way = circle.centre - square_centre_;
    const Vector2d local(std::abs(way.dot(ahead_)) - kHalf, std::abs(way.dot(left())) - kHalf);
    const double distance = local.maxCoeff() <= 0.0 ? local.maxCoeff() : local.cwiseMax(0.0).norm();
    return circle.radius - distance;
  }

  double squaresDepth(const FootbotDepth& other) const {
    const Vector2d way = other.square_centre_ - square_centre_;
    double smallest = 1.0;
    for (const Vector2d& axis : {ahead_, left(), other.ahead_, other.left()}) {
      const double reach = kHalf * (std::abs(axis.dot(ahead_)) + std::abs(axis.dot(left())) +
                                    std::abs(axis.dot(other.ahead_)) + std::abs(axis.dot(other.left())));
      smallest = std::min(smallest, reach - std::abs(axis.dot(way)));
    }
    return smallest;
  }

  Vector2d centre_;
  Vector2d ahead_;
  Vector2d square_centre_;
  std::vector<Circle> circles_;
};

class Crowd {
 public:
  static constexpr double kPacked = 0.209;  // m between neighbours: 0.6 of the area is footbot
  static constexpr double kWall = 8.0;      // m, where a wall stands across

  Crowd(int count, int per_line, double distance, int subclock) : world({10.0, 10.0, 1.0}, subclock) {
    wall = world.addBlock({0.2, 9.0, 0.5}, {kWall + 0.1, 5.0, 0.25});
    for (int i = 0; i < count; ++i) {
      const int line = i / per_line;
      const double x = 0.5 + distance * (i % per_line + 0.5 * (line % 2));
      const double y = 0.5 + distance * std::sqrt(0.75) * line;
      rows.push_back(world.addFootbot(flatPose(x, y)));
    }
  }

  /// Turns all robots towards the point and drives them.
  void driveTo(const Vector2d& point) {
    for (const Row row : rows) {
      const Pose& pose = world.pose(row);
      const Vector2d way = point - pose.position.head<2>();
      const double error = std::remainder(std::atan2(way.y(), way.x()) - headingOf(pose), 2.0 * M_PI);
      world.drive(row, 0.2, std::clamp(2.0 * error, -2.0, 2.0));
    }
  }

  double deepest() const {
    std::vector<FootbotDepth> footbots;
    double deepest = -1.0;
    for (const Row row : rows) {
      footbots.emplace_back(world.pose(row));
      const double front = (world.pose(row).orientation * Eigen::Vector3d::UnitX()).x();
      deepest = std::max(deepest, world.pose(row).position.x() + 0.085 - kWall);
      deepest = std::max(deepest, world.pose(row).position.x() + 0.09 * front + 0.02 * std::abs(front) +
                                      0.02 * std::sqrt(std::max(0.0, 1.0 - front * front)) - kWall);
    }
    for (std::size_t i = 0; i < footbots.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        deepest = std::max(deepest, footbots[i].depthIn(footbots[k]));
      }
    }
    return deepest;
  }

  double meanDistanceTo(const Vector2d& point) const {
    double sum = 0.0;
    for (const Row row : rows) {
      sum += (world.pose(row).position.head<2>() - point).norm();
    }
    return sum / static_cast<double>(rows.size());
  }

  World world;
  Row wall = kNoRow;
  std::vector<Row> rows;
};

int ticksOfEachPhase() {
  const char* wanted = std::getenv("SWARMANOID_LONG_TESTS");
  return wanted != nullptr && std::string(wanted) == "1" ? 2000 : 60;
}

TEST(CrowdTest, TheCheckerFindsOverlaps) {
  const FootbotDepth a(flatPose(1.0, 1.0));
  EXPECT_NEAR(a.depthIn(FootbotDepth(flatPose(1.0, 1.16))), 0.016, 1e-12);       // wheel in wheel
  EXPECT_NEAR(a.depthIn(FootbotDepth(flatPose(1.19, 1.0))), 0.005, 1e-12);       // gripper in body
  EXPECT_NEAR(a.depthIn(FootbotDepth(flatPose(1.21, 1.0, M_PI))), 0.01, 1e-12);  // gripper in gripper
  EXPECT_NEAR(a.depthIn(FootbotDepth(flatPose(1.21, 1.03, M_PI))), 0.01, 1e-12);
  EXPECT_LT(a.depthIn(FootbotDepth(flatPose(1.221, 1.0, M_PI))), 0.0);
}

TEST(CrowdTest, NothingEverOverlapsAndTheRunRepeatsToTheBit) {
  const int ticks = ticksOfEachPhase();
  Crowd crowd(1000, 32, Crowd::kPacked, 2);
  Crowd again(1000, 32, Crowd::kPacked, 2);
  ASSERT_LT(crowd.deepest(), 0.0);
  const Vector2d middle(4.0, 3.5);
  const double start = crowd.meanDistanceTo(middle);
  for (int tick = 0; tick < 2 * ticks; ++tick) {
    const Vector2d target = tick < ticks ? middle : Vector2d(20.0, 3.5);
    for (Crowd* each : {&crowd, &again}) {
      each->driveTo(target);
      each->world.step();
      ++each->world.space.tick;
    }
    ASSERT_LT(crowd.deepest(), kAllowedDepth) << "tick " << tick;
    ASSERT_EQ(stateHash(crowd.world.space), stateHash(again.world.space)) << "tick " << tick;
    if (tick == ticks - 1) {
      EXPECT_LT(crowd.meanDistanceTo(middle), start - 0.05);
    }
  }
  EXPECT_GT(crowd.deepest(), -0.01);  // they did get close
}

TEST(CrowdTest, RobotsThatLookAroundInEachTickGoWhereTheOthersGo) {
  Crowd crowd(300, 15, 0.4, 1);
  Crowd careful(300, 15, 0.4, 1);
  for (int tick = 0; tick < 400; ++tick) {
    careful.world.engine.place(careful.world.space, careful.wall);  // discards all that the engine knows of distances
    for (Crowd* each : {&crowd, &careful}) {
      each->driveTo(tick < 200 ? Vector2d(3.5, 3.5) : Vector2d(tick % 80 < 40 ? -20.0 : 20.0, 3.5));
      each->world.step();
      ++each->world.space.tick;
    }
    ASSERT_EQ(stateHash(crowd.world.space), stateHash(careful.world.space)) << "tick " << tick;
    ASSERT_LT(crowd.deepest(), kAllowedDepth) << "tick " << tick;
  }
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
