#include "swarmanoid_rendering/camera.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

TEST(CameraTest, LooksAlongXWithZUpAtFirst) {
  const CameraAxes axes = axesOf(Camera{});
  EXPECT_TRUE(axes.forward.isApprox(Vector3d::UnitX()));
  EXPECT_TRUE(axes.right.isApprox(-Vector3d::UnitY()));
  EXPECT_TRUE(axes.up.isApprox(Vector3d::UnitZ()));
}

TEST(CameraTest, HeadingTurnsLeftPitchLooksUpAndRollLiftsTheLeft) {
  Camera camera;
  camera.heading = 0.61;
  camera.pitch = -0.43;
  camera.roll = 0.27;
  const CameraAxes axes = axesOf(camera);
  EXPECT_NEAR(std::atan2(axes.forward.y(), axes.forward.x()), 0.61, 1e-12);
  EXPECT_NEAR(std::asin(axes.forward.z()), -0.43, 1e-12);
  // without roll the right axis is horizontal; with roll it sinks by the sine of the roll, scaled by the cosine of
  // pitch
  EXPECT_NEAR(axes.right.z(), -std::sin(0.27) * std::cos(-0.43), 1e-12);
  EXPECT_TRUE(axes.right.cross(axes.forward).isApprox(axes.up, 1e-12));
  EXPECT_NEAR(axes.up.norm(), 1.0, 1e-12);
}

TEST(CameraTest, AnOverviewHasAllCornersInThePictureAndOneNearItsBorder) {
  for (const double aspect : {0.6, 1.33, 2.4}) {
    for (const Vector3d& size : {Vector3d(3.1, 4.7, 2.0), Vector3d(40.0, 2.5, 0.3), Vector3d(1.0, 9.0, 30.0)}) {
      const double field_of_view = 1.13;
      const Vector3d least(-1.7, 0.4, 0.2);
      const Camera camera = overview({least, Vector3d(least + size)}, field_of_view, aspect);
      const CameraAxes axes = axesOf(camera);
      double farthest = 0.0;  // from the centre of the picture; 1: at its border
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3d at((corner & 1) != 0 ? size.x() : 0.0, (corner & 2) != 0 ? size.y() : 0.0,
                          (corner & 4) != 0 ? size.z() : 0.0);
        const Vector3d seen = least + at - camera.position;
        const double depth = axes.forward.dot(seen);
        ASSERT_GT(depth, 0.0);
        const double border = depth * std::tan(0.5 * field_of_view);
        farthest = std::max(
            {farthest, std::abs(axes.right.dot(seen)) / border, aspect * std::abs(axes.up.dot(seen)) / border});
      }
      EXPECT_NEAR(farthest, 1.0 / 1.04, 1e-9) << size.transpose() << ", aspect " << aspect;
    }
  }
}

}  // namespace
}  // namespace swarmanoid
