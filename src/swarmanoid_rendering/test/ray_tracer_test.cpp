#include "swarmanoid_rendering/ray_tracer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swarmanoid {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr int kWidth = 97;
constexpr int kHeight = 61;
const Tint kRed(0.9F, 0.2F, 0.1F, 1.0F);
const Tint kGreen(0.15F, 0.7F, 0.3F, 1.0F);

/// A camera in a general position.
Camera askew() {
  Camera camera;
  camera.position = {1.3, -0.7, 2.1};
  camera.heading = 0.68;
  camera.pitch = -0.59;
  camera.roll = 0.21;
  camera.field_of_view = 0.97;
  return camera;
}

/// The direction of the ray through the middle of a pixel.
Vector3d through(const Camera& camera, int column, int row) {
  const CameraAxes axes = axesOf(camera);
  const double pixel = 2.0 * std::tan(0.5 * camera.field_of_view) / kWidth;
  return (axes.forward + (column + 0.5 - 0.5 * kWidth) * pixel * axes.right +
          (0.5 * kHeight - row - 0.5) * pixel * axes.up)
      .normalized();
}

RayTracer::Options plain() {
  RayTracer::Options options;
  options.samples = 1;
  return options;
}

bool isBackground(const Picture& picture, int column, int row) {
  for (int channel = 0; channel < 3; ++channel) {
    if (picture.pixel(column, row)[channel] != std::lround(255.0F * RayTracer::background()[channel])) {
      return false;
    }
  }
  return true;
}

void expectColor(const Picture& picture, int column, int row, const Vector3f& color) {
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(picture.pixel(column, row)[channel], 255.0 * color[channel], 1.0)
        << "channel " << channel << " at " << column << ", " << row;
  }
}

/// Expects each pixel to show a body exactly if `hits` is true for its ray; pixels whose neighbours differ may be
/// either.
template <class Hits>
void expectOutline(const Geometry& geometry, Hits hits) {
  RayTracer tracer;
  tracer.set(RayTracer::Part::kMoving, geometry);
  const Camera camera = askew();
  const Picture picture = tracer.render(camera, kWidth, kHeight, plain());
  int shown = 0;
  int sure = 0;
  for (int row = 1; row + 1 < kHeight; ++row) {
    for (int column = 1; column + 1 < kWidth; ++column) {
      const bool is_hit = hits(camera.position, through(camera, column, row));
      bool is_inner = true;
      for (int beside = 0; beside < 9; ++beside) {
        is_inner =
            is_inner && hits(camera.position, through(camera, column + beside % 3 - 1, row + beside / 3 - 1)) == is_hit;
      }
      sure += is_inner ? 1 : 0;
      shown += is_inner && is_hit ? 1 : 0;
      EXPECT_TRUE(!is_inner || isBackground(picture, column, row) != is_hit) << "at " << column << ", " << row;
    }
  }
  EXPECT_GT(shown, 40);
  EXPECT_GT(sure, 4000);
}

Vector3d ahead(double distance, double aside) {
  const CameraAxes axes = axesOf(askew());
  return askew().position + distance * axes.forward + aside * axes.right;
}

TEST(RayTracerTest, ABallIsWhereItIs) {
  const Vector3d middle = ahead(3.0, 0.31);
  const double radius = 0.47;
  Geometry geometry;
  geometry.addBall(middle, radius, kRed);
  expectOutline(geometry, [&](const Vector3d& from, const Vector3d& direction) {
    return (middle - from).cross(direction).norm() < radius;
  });
}

TEST(RayTracerTest, ARodIsAsThickAsItIs) {
  const Vector3d from = ahead(2.0, -0.5);
  const Vector3d to = ahead(4.0, 1.1) + Vector3d(0.0, 0.0, 0.3);
  const double radius = 0.2;
  Geometry geometry;
  geometry.addRod(from, to, radius, kRed);
  expectOutline(geometry, [&](const Vector3d& eye, const Vector3d& direction) {
    double nearest = 1e9;  // distance of the ray to balls along the rod
    for (int part = 0; part <= 400; ++part) {
      nearest = std::min(nearest, (from + part / 400.0 * (to - from) - eye).cross(direction).norm());
    }
    return nearest < radius;
  });
}

/// Whether a point along the ray is in the body, by `inside` [frame of the body].
template <class Inside>
bool marches(const Eigen::Isometry3d& pose, const Vector3d& eye, const Vector3d& direction, Inside inside) {
  for (double distance = 1.5; distance < 5.0; distance += 0.004) {
    if (inside(pose.inverse() * (eye + distance * direction))) {
      return true;
    }
  }
  return false;
}

TEST(RayTracerTest, BoxesCylindersAndEllipsoidsHaveTheirSizesAlongTheirAxes) {
  const Eigen::Isometry3d pose =
      Eigen::Translation3d(ahead(3.2, 0.1)) * Eigen::AngleAxisd(0.83, Vector3d(0.3, -0.5, 0.8).normalized());
  const Vector3d size(1.3, 0.7, 0.4);
  const auto expect = [&](const Geometry& geometry, auto inside) {
    expectOutline(geometry, [&](const Vector3d& eye, const Vector3d& direction) {
      return marches(pose, eye, direction, [&](const Vector3d& at) { return inside(2.0 * at.cwiseQuotient(size)); });
    });
  };
  Geometry box;
  box.addBox(pose, size, kRed);
  expect(box, [](const Vector3d& at) { return at.cwiseAbs().maxCoeff() < 1.0; });
  Geometry cylinder;
  cylinder.addCylinder(pose, size, kRed);
  expect(cylinder, [](const Vector3d& at) { return at.head<2>().norm() < 1.0 && std::abs(at.z()) < 1.0; });
  Geometry ellipsoid;
  ellipsoid.addEllipsoid(pose, size, kRed);
  expect(ellipsoid, [](const Vector3d& at) { return at.norm() < 1.0; });
}

/// Sees a floor at z = 0 from straight above, 97 by 61 cm, with the origin at the centre of the picture.
Camera above() {
  Camera camera;
  camera.position = {0.0, 0.0, 2.0};
  camera.pitch = -0.5 * M_PI;
  camera.heading = 0.5 * M_PI;  // north is up
  camera.field_of_view = 2.0 * std::atan2(0.485, 2.0);
  return camera;
}

Geometry floorOf(const Tint& tint) {
  Geometry geometry;
  geometry.addBox(Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -0.05)), {5.0, 5.0, 0.1}, tint);
  return geometry;
}

/// The pixel of a point on the floor.
int columnOf(double x) { return static_cast<int>(std::floor(100.0 * x + 0.5 * kWidth)); }
int rowOf(double y) { return static_cast<int>(std::floor(0.5 * kHeight - 100.0 * y)); }

float inTheSun() { return RayTracer::kAmbient + (1.0F - RayTracer::kAmbient) * RayTracer::sun().z(); }

TEST(RayTracerTest, AFloorShinesByTheHeightOfTheSunAndHalfInShadow) {
  RayTracer tracer;
  tracer.set(RayTracer::Part::kFixed, floorOf(kGreen));
  Geometry ball;
  const Vector3d middle(0.1, 0.05, 0.4);
  ball.addBall(middle, 0.06, kRed);
  tracer.set(RayTracer::Part::kMoving, ball);
  const Picture picture = tracer.render(above(), kWidth, kHeight, plain());
  // the shadow falls away from the sun, in proportion to the height of the ball
  const Vector3d shadow = middle - middle.z() / RayTracer::sun().z() * RayTracer::sun().cast<double>();
  expectColor(picture, columnOf(shadow.x()), rowOf(shadow.y()), RayTracer::kAmbient * kGreen.head<3>());
  expectColor(picture, columnOf(-0.37), rowOf(-0.21), inTheSun() * kGreen.head<3>());

  Geometry rod;
  rod.addRod(middle, middle + Vector3d(0.01, 0.0, 0.0), 0.06, kRed);
  tracer.set(RayTracer::Part::kMoving, rod);
  const Picture of_rod = tracer.render(above(), kWidth, kHeight, plain());
  expectColor(of_rod, columnOf(shadow.x()), rowOf(shadow.y()), inTheSun() * kGreen.head<3>());
  tracer.set(RayTracer::Part::kMoving, ball);

  RayTracer::Options options = plain();
  options.has_shadows = false;
  const Picture without = tracer.render(above(), kWidth, kHeight, options);
  expectColor(without, columnOf(shadow.x()), rowOf(shadow.y()), inTheSun() * kGreen.head<3>());
}

TEST(RayTracerTest, WhatIsTranslucentLetsItsPartThrough) {
  RayTracer tracer;
  Geometry geometry = floorOf(kGreen);
  const float alpha = 0.3F;
  const Tint glass(0.9F, 0.2F, 0.1F, alpha);
  geometry.addTriangle({Vector3d(-9.0, -9.0, 0.5), Vector3d(9.0, -9.0, 0.5), Vector3d(0.0, 9.0, 0.5)}, glass);
  tracer.set(RayTracer::Part::kFixed, geometry);
  const Picture picture = tracer.render(above(), kWidth, kHeight, plain());
  const float sun_below = RayTracer::kAmbient + (1.0F - RayTracer::kAmbient) * (1.0F - alpha) * RayTracer::sun().z();
  expectColor(picture, 13, 44, alpha * inTheSun() * glass.head<3>() + (1.0F - alpha) * sun_below * kGreen.head<3>());
}

TEST(RayTracerTest, PartsAreReplacedOneByOne) {
  RayTracer tracer;
  EXPECT_TRUE(isBackground(tracer.render(above(), kWidth, kHeight, plain()), 50, 30)) << "nothing is there at first";
  tracer.set(RayTracer::Part::kFixed, floorOf(kGreen));
  Geometry ball;
  ball.addBall({0.0, 0.0, 0.3}, 0.1, kRed);
  tracer.set(RayTracer::Part::kMoving, ball);
  const auto red = [&] { return static_cast<int>(tracer.render(above(), kWidth, kHeight, plain()).pixel(48, 30)[0]); };
  EXPECT_GT(red(), 100);
  tracer.set(RayTracer::Part::kMoving, Geometry());
  EXPECT_NEAR(red(), 255.0F * inTheSun() * kGreen.x(), 1.0);
  tracer.set(RayTracer::Part::kFixed, Geometry());
  EXPECT_EQ(red(), std::lround(255.0F * RayTracer::background().x()));
}

TEST(RayTracerTest, ABorderIsBetweenTheColoursOfItsSides) {
  RayTracer tracer;
  Geometry geometry;  // its border lies in the middle of column 58
  geometry.addBox(Eigen::Isometry3d(Eigen::Translation3d(-1.9, 0.0, -0.05)), {4.0, 5.0, 0.1}, kGreen);
  tracer.set(RayTracer::Part::kFixed, geometry);
  const Picture picture = tracer.render(above(), kWidth, kHeight, RayTracer::Options());
  const Vector3f inside = inTheSun() * kGreen.head<3>();
  expectColor(picture, 57, 30, inside);
  expectColor(picture, 58, 30, 0.5F * (inside + RayTracer::background()));
  expectColor(picture, 59, 30, RayTracer::background());
}

}  // namespace
}  // namespace swarmanoid
