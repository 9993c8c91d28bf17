#include "planar/plane.hpp"

#include <gtest/gtest.h>

namespace swarmanoid::planar {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(PlaneTest, EachAxisHasARightHandedFrame) {
  const Vector3d p(1.0, 2.0, 3.0);
  EXPECT_EQ(Plane('z', 0.0).toLocal(p), Vector2d(1.0, 2.0));
  EXPECT_EQ(Plane('x', 0.0).toLocal(p), Vector2d(2.0, 3.0));
  EXPECT_EQ(Plane('y', 0.0).toLocal(p), Vector2d(3.0, 1.0));
  for (const char axis : {'x', 'y', 'z'}) {
    const Plane plane(axis, 0.0);
    const Vector3d u = plane.toGlobal({1.0, 0.0}, 0.0);
    const Vector3d v = plane.toGlobal({0.0, 1.0}, 0.0);
    EXPECT_EQ(u.cross(v), plane.normal()) << axis;
    EXPECT_EQ(plane.toGlobal(plane.toLocal(p), plane.along(p)), p) << axis;
    EXPECT_EQ(plane.axisName(), std::string(1, axis));
  }
}

TEST(PlaneTest, AnOrientationIsAHeadingAboutTheNormalAfterABase) {
  for (const char axis : {'x', 'y', 'z'}) {
    const Plane plane(axis, 0.0);
    for (const double heading : {-3.0, -0.5, 0.0, 1.0, 3.1}) {
      // a tilt about an axis in the plane has no heading
      const Quaterniond tilt(AngleAxisd(0.7, plane.toGlobal({0.6, 0.8}, 0.0)));
      const Quaterniond orientation = AngleAxisd(heading, plane.normal()) * tilt;
      EXPECT_NEAR(plane.headingOf(orientation), heading, 1e-12);
      EXPECT_LT(plane.baseOf(orientation).angularDistance(tilt), 1e-7);
      EXPECT_LT(plane.orientation(heading, plane.baseOf(orientation)).angularDistance(orientation), 1e-7);
    }
  }
}

TEST(PlaneTest, UprightBodiesHaveNoBaseWhateverTheirHeading) {
  const Plane plane('z', 0.0);
  for (int i = -31; i <= 31; ++i) {
    const Quaterniond orientation(AngleAxisd(0.1 * i, Vector3d::UnitZ()));
    EXPECT_EQ(plane.baseOf(orientation).coeffs(), Quaterniond::Identity().coeffs());
  }
}

TEST(PlaneTest, UprightIsAlongTheNormalEitherWay) {
  const Plane wall('x', 0.0);
  EXPECT_FALSE(wall.isUpright(Quaterniond::Identity()));
  EXPECT_TRUE(wall.isUpright(Quaterniond(AngleAxisd(M_PI / 2.0, Vector3d::UnitY()))));
  EXPECT_TRUE(wall.isUpright(Quaterniond(AngleAxisd(-M_PI / 2.0, Vector3d::UnitY()))));
}

}  // namespace
}  // namespace swarmanoid::planar
