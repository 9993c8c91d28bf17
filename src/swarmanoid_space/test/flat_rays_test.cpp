#include "swarmanoid_space/rays/flat_rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace swarmanoid {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr std::size_t kCount = 24;
using Rays = FlatRays<kCount>;

struct Ray {
  Vector2d from;
  Vector2d step;

  double distanceTo(const Vector2d& point) const {
    const double part = std::clamp((point - from).dot(step) / step.squaredNorm(), 0.0, 1.0);
    return (from + part * step - point).norm();
  }
};

class FlatRaysTest : public testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vector2d place(double most) { return {uniform(-most, most), uniform(-most, most)}; }

  void aim() {
    rays.resize(kCount);
    lines.clear();
    for (std::size_t k = 0; k < kCount; ++k) {
      lines.push_back({place(0.2), place(0.3)});
      rays.set(k, lines.back().from, lines.back().step);
    }
    rays.measure();
  }

  std::mt19937 random{11};
  Rays rays;
  std::vector<Ray> lines;
};

bool has(RayMask mask, std::size_t k) { return (mask >> k & 1U) != 0; }

TEST_F(FlatRaysTest, RaysThatMeetACircleAreNear) {
  int met = 0;
  int far = 0;
  for (int i = 0; i < 500; ++i) {
    aim();
    const Vector2d point = place(0.6);
    const double radius = uniform(0.01, 0.2);
    const RayMask near = rays.nearPoint(point, radius);
    for (std::size_t k = 0; k < kCount; ++k) {
      const double distance = lines[k].distanceTo(point);
      // maximum distance of a corner of the box around a ray
      EXPECT_TRUE(distance >= radius - 1e-9 || has(near, k)) << k << ": " << distance << " of " << radius;
      EXPECT_TRUE(distance <= M_SQRT2 * radius + 1e-9 || !has(near, k)) << k << ": " << distance << " of " << radius;
      met += distance < radius ? 1 : 0;
      far += has(near, k) ? 0 : 1;
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(far, 1000);
}

TEST_F(FlatRaysTest, RaysAreNearABoxThatTheirOwnBoxMeets) {
  int near_count = 0;
  for (int i = 0; i < 500; ++i) {
    aim();
    const Vector2d corner = place(0.5);
    const AlignedBox2d box(corner, corner + Vector2d(uniform(0.0, 0.4), uniform(0.0, 0.05)));
    const RayMask near = rays.nearBox(box);
    for (std::size_t k = 0; k < kCount; ++k) {
      const Vector2d from = lines[k].from;
      const Vector2d to = from + lines[k].step;
      const AlignedBox2d around(from.cwiseMin(to), from.cwiseMax(to));
      const double gap = around.exteriorDistance(box);
      EXPECT_EQ(has(near, k), gap < 1e-10) << k << ": " << gap;
      near_count += has(near, k) ? 1 : 0;
    }
  }
  EXPECT_GT(near_count, 500);
}

TEST(FlatRaysTouchTest, WhoTouchesIsNear) {
  Rays rays;
  rays.resize(1);
  rays.set(0, {0.0, 0.0}, {0.1, 0.0});
  rays.measure();
  EXPECT_EQ(rays.nearPoint({0.05, 0.03}, 0.03), 1U);
  EXPECT_EQ(rays.nearPoint({0.05, 0.0301}, 0.03), 0U);
  EXPECT_EQ(rays.nearPoint({0.13, 0.0}, 0.03), 1U);
  EXPECT_EQ(rays.nearPoint({0.1301, 0.0}, 0.03), 0U);
  EXPECT_EQ(rays.nearBox({Vector2d(0.1, -1.0), Vector2d(0.2, 1.0)}), 1U);
  EXPECT_EQ(rays.nearBox({Vector2d(0.1001, -1.0), Vector2d(0.2, 1.0)}), 0U);
}

}  // namespace
}  // namespace swarmanoid
