// Results do not depend on the axes of W: a turned world behaves the same, turned.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>
#include <string>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Places entities as if the world were turned about (5, 5).
class Turned {
 public:
  explicit Turned(double angle) : turn_(Eigen::AngleAxisd(angle, Vector3d::UnitZ())) {}
  /// @param x, y from the middle
  Pose at(double x, double y, double heading, double z = 0.0) const {
    return at({x, y, z}, Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ())));
  }
  Pose at(const Vector3d& position, const Quaterniond& orientation) const {
    return {turn_ * position + Vector3d(5.0, 5.0, 0.0), turn_ * orientation};
  }
  Vector3d back(const Vector3d& position) const { return turn_.conjugate() * (position - Vector3d(5.0, 5.0, 0.0)); }

 private:
  Quaterniond turn_;
};

TEST(IsotropyTest, APreyThatIsPushedDeadCentreGoesStraightOn) {
  for (int i = 0; i < 24; ++i) {
    const double heading = (3.7 + 15.0 * i) * kDegree;
    const Turned turned(heading);
    World world;
    // the prey itself is not turned
    const Row prey =
        world.add(cylindricPreyModel(0.1, 0.12, 1.0), {turned.at(0.0, 0.0, 0.0).position, Quaterniond::Identity()});
    const Row footbot = world.addFootbot(turned.at(-0.22, 0.0, 0.0));
    world.drive(footbot, 0.1);
    world.step(51);
    const Vector3d way = turned.back(world.pose(prey).position);
    EXPECT_GT(way.x(), 0.48) << i;
    EXPECT_NEAR(way.y(), 0.0, 1e-3) << i;
  }
}

/// Experiments of 20 s in which small errors stay small.
struct Scene {
  const char* name;
  std::function<void(World&, const Turned&)> make;
};

void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }

class TurnedTest : public testing::TestWithParam<Scene> {};

TEST_P(TurnedTest, RunsTheSame) {
  const auto run = [](double angle) {
    const Turned turned(angle);
    World world;
    GetParam().make(world, turned);
    world.step(200);
    std::vector<Vector3d> places;
    for (const Row row : world.space.entities.order) {
      places.push_back(turned.back(world.pose(row).position));
    }
    return places;
  };
  const std::vector<Vector3d> expected = run(0.0);
  for (const double degrees : {17.0, 37.0, 61.0}) {
    const std::vector<Vector3d> found = run(degrees * kDegree);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LT((found[i] - expected[i]).norm(), 2e-3) << "entity " << i << ", turned by " << degrees;
    }
  }
}

void pushOffCentre(World& world, const Turned& turned) {
  world.add(cylindricPreyModel(0.1, 0.12, 1.0), turned.at(0.0, 0.013, 0.0));
  world.drive(world.addFootbot(turned.at(-0.23, 0.0, 0.0)), 0.06, 0.01);
}

void slideAlongAWall(World& world, const Turned& turned) {
  world.addBlock({0.1, 6.0, 0.5}, 0.0, turned.at(0.05, 0.0, 0.0, 0.25));
  world.drive(world.addFootbot(turned.at(-0.3, -1.5, 58.0 * kDegree)), 0.11);
}

void drawAPreyInACurve(World& world, const Turned& turned) {
  const Row footbot = world.addFootbot(turned.at(0.0, 0.0, 0.3));
  const Vector3d ahead(std::cos(0.3), std::sin(0.3), 0.0);
  world.add(cylindricPreyModel(0.1, 0.12, 1.5), turned.at(0.212 * ahead.x(), 0.212 * ahead.y(), 0.7));
  world.setGripper(footbot, true);
  world.drive(footbot, -0.07, 0.11);
}

void pushABlockOverACorner(World& world, const Turned& turned) {
  world.addBlock({0.3, 0.2, 0.1}, 1.2, turned.at(0.3, 0.02, 0.2, 0.05));
  world.drive(world.addFootbot(turned.at(-0.05, 0.0, 0.0)), 0.05);
}

void standOnASlope(World& world, const Turned& turned) {
  const Quaterniond tilt(Eigen::AngleAxisd(9.0 * kDegree, Vector3d(0.28, 0.96, 0.0)));
  world.addBlock({3.0, 3.0, 0.2}, 0.0, turned.at({0.0, 0.0, 0.6}, tilt));
  world.add(cylindricPreyModel(0.1, 0.12, 1.0),
            turned.at(Vector3d(0.0, 0.0, 0.6) + tilt * Vector3d(0.5, 0.3, 0.1), tilt));
  const Row footbot = world.addFootbot(turned.at(Vector3d(0.0, 0.0, 0.6) + tilt * Vector3d(-0.3, -0.5, 0.1), tilt));
  world.drive(footbot, 0.04, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TurnedTest,
                         testing::Values(Scene{"PushOffCentre", pushOffCentre},
                                         Scene{"SlideAlongAWall", slideAlongAWall},
                                         Scene{"DrawAPreyInACurve", drawAPreyInACurve},
                                         Scene{"PushABlockOverACorner", pushABlockOverACorner},
                                         Scene{"StandOnASlope", standOnASlope}),
                         [](const auto& scene) { return std::string(scene.param.name); });

/// A prey on a slope of wood, or on level ground that is a slope: the direction of gravity relative to its foot
/// decides.
TEST(TopplingTest, APreyFallsWhenTheVerticalLeavesItsFoot) {
  constexpr double kRadius = 0.06;  // m
  constexpr double kHeight = 0.4;   // m
  const double limit = std::atan(kRadius / (0.5 * kHeight));
  for (double direction = 4.0; direction < 360.0; direction += 51.0) {
    for (const double part : {0.97, 1.03}) {
      World world({{"friction", "0.9"}});
      const Vector3d axis(-std::sin(direction * kDegree), std::cos(direction * kDegree), 0.0);
      const Quaterniond tilt(Eigen::AngleAxisd(part * limit, axis));
      world.addBlock({2.0, 2.0, 0.2}, 0.0, {Vector3d(5.0, 5.0, 1.5), tilt});
      const Row prey = world.add(cylindricPreyModel(kRadius, kHeight, 0.8),
                                 {Vector3d(5.0, 5.0, 1.5) + tilt * Vector3d(0.0, 0.0, 0.1), tilt});
      world.step(20);
      EXPECT_EQ(world.pose(prey).orientation.angularDistance(tilt) > 0.3, part > 1.0) << direction << ", " << part;
    }
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
