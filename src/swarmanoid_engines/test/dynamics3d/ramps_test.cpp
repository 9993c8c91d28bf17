// Boxes on tilted boxes: they rest within the friction angle, and beyond it slide by the laws of Newton and Coulomb.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <vector>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond about(double angle, const Vector3d& axis) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); }

/// A box on a ramp of its own.
struct Load {
  Row row = kNoRow;
  Vector3d start = Vector3d::Zero();
  Vector3d down = Vector3d::Zero();  // along the ramp
  Vector3d out = Vector3d::Zero();   // of the ramp

  Vector3d way(const World& world) const { return world.pose(row).position - start; }
};

/// Ramps high over the ground, far from each other.
class Ramps {
 public:
  explicit Ramps(World::Values values, unsigned seed) : world(std::move(values)), random_(seed) {}

  double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  /// @param angle of the ramp; @param heading of its descent; @param turn of the box on it [rad]
  void add(double angle, double heading, double turn, const Vector3d& ramp, const Vector3d& box, double mass,
           const Eigen::Vector2d& place) {
    constexpr double kApart = 4.0;  // m
    constexpr int kInARow = 40;
    const auto number = static_cast<int>(loads.size());
    const Vector3d middle(kApart * (number % kInARow), kApart * (number / kInARow), 3.0);
    const Quaterniond tilt = about(heading, Vector3d::UnitZ()) * about(angle, Vector3d::UnitY());
    world.addBlock(ramp, 0.0, {middle, tilt});
    const Vector3d above(place.x(), place.y(), 0.5 * (ramp.z() + box.z()));
    Load load;
    load.down = tilt * Vector3d::UnitX();
    load.out = tilt * Vector3d::UnitZ();
    load.row = world.addBlock(box, mass, {middle + tilt * above, tilt * about(turn, Vector3d::UnitZ())});
    load.start = world.pose(load.row).position;
    loads.push_back(load);
  }

  World world;
  std::vector<Load> loads;

 private:
  std::mt19937_64 random_;
};

/// Turn of the box relative to the ramp: some quarter turns, or any angle [rad].
double turnOnRamp(Ramps& ramps) {
  return ramps.pick(3) == 0 ? ramps.within(0.0, 2.0 * M_PI) : 0.5 * M_PI * ramps.pick(4);
}

TEST(RampsTest, BoxesRestWithinTheFrictionAngle) {
  // mu 0.9: all rest below 41.9 degrees. The boxes are at least twice as wide as high: they do not topple, either.
  const int rounds = std::getenv("SWARMANOID_LONG_TESTS") != nullptr ? 40 : 1;
  int moved = 0;
  double most = 0.0;
  for (int round = 0; round < rounds; ++round) {
    Ramps ramps({{"friction", "0.9"}}, static_cast<unsigned>(round + 1));
    for (int i = 0; i < 100; ++i) {
      const double wide = ramps.within(0.06, 0.4);
      const Vector3d box(wide, wide * ramps.within(0.7, 1.4), ramps.within(0.02, 0.35 * wide));
      ramps.add(ramps.within(2.0, 30.0) * kDegree, ramps.within(0.0, 2.0 * M_PI), turnOnRamp(ramps),
                {1.7, 1.1, ramps.within(0.05, 0.2)}, box, ramps.within(0.1, 3.0),
                {ramps.within(-0.4, 0.4), ramps.within(-0.2, 0.2)});
    }
    ramps.world.step(50);  // 5 s
    for (const Load& load : ramps.loads) {
      const double way = load.way(ramps.world).norm();
      most = std::max(most, way);
      moved += way > 1e-3 ? 1 : 0;
    }
  }
  EXPECT_EQ(moved, 0);
  EXPECT_LT(most, 1e-3);
  RecordProperty("most_um", static_cast<int>(1e6 * most));
}

/// Ways of boxes from rest on ramps of many headings, against s = g (sin a - mu cos a) t2 / 2; none leaves its surface.
/// @param time [s]
void expectToSlide(double friction, double time, const char* subclock) {
  Ramps ramps({{"friction", std::to_string(friction)}, {"subclock", subclock}}, 5);
  std::vector<double> expected;
  for (int i = 0; i < 40; ++i) {
    const double angle = ramps.within(23.0, 29.0) * kDegree;
    ramps.add(angle, (1.7 + 9.0 * i) * kDegree, turnOnRamp(ramps), {4.0, 1.1, 0.1}, {0.11, 0.13, 0.05},
              ramps.within(0.1, 3.0), {-1.7, ramps.within(-0.3, 0.3)});
    expected.push_back(0.5 * kGravity * (std::sin(angle) - friction * std::cos(angle)) * time * time);
  }
  ramps.world.step(static_cast<int>(std::lround(time / 0.1)));
  for (std::size_t i = 0; i < ramps.loads.size(); ++i) {
    const Load& load = ramps.loads[i];
    const Vector3d way = load.way(ramps.world);
    EXPECT_NEAR(load.down.dot(way), expected[i], 0.03 * expected[i]) << "ramp " << i;
    EXPECT_NEAR(load.out.dot(way), 0.0, 1e-4) << "ramp " << i;
    EXPECT_LT((way - load.down.dot(way) * load.down).norm(), 0.01 * expected[i]) << "ramp " << i;
  }
}

TEST(RampsTest, BoxesSlideAsCoulombHasIt) {
  for (const char* subclock : {"10", "20", "50"}) {
    expectToSlide(0.31, 1.2, subclock);
    expectToSlide(0.0, 0.9, subclock);
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
