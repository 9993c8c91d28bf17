// Contacts with rough ground, against geometry; rays, against ODE's own heightfield.
#include "dynamics3d/contacts/ground_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "terrains.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

CollisionShape shapeOf(CollisionShape::Kind kind, const Vector3d& half) {
  CollisionShape shape;
  shape.kind = kind;
  shape.half_extent = half;
  return shape;
}

PlacedSolid ballAt(double radius, const Vector3d& centre) {
  return {shapeOf(CollisionShape::Kind::kSphere, Vector3d::Constant(radius)), {centre, Eigen::Quaterniond::Identity()}};
}

/// A ridge along y at x = 5, falling by `slope` to both sides.
std::shared_ptr<const Terrain> ridge(double slope) {
  return terrainOf([slope](double x, double) { return 0.5 - slope * std::abs(x - 5.0); }, 0.1);
}

TEST(BallTest, HasOneContactOnAPlaneWhateverTheTriangles) {
  const auto plane = [](double x, double y) { return 0.2 * x - 0.1 * y; };
  const GroundSurface ground(terrainOf(plane, 0.05), 0.0);
  const Vector3d normal = Vector3d(-0.2, 0.1, 1.0).normalized();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-0.8, 0.8);
  for (int i = 0; i < 500; ++i) {
    const Vector3d foot(5.0 + part(random), 5.0 + part(random), 0.0);
    const Vector3d on_plane = foot + plane(foot.x(), foot.y()) * Vector3d::UnitZ();
    const double depth = 0.0015 * part(random);
    const SurfaceContacts contacts = collideGround(ground, ballAt(0.03, on_plane + (0.03 - depth) * normal), 0.002);
    ASSERT_EQ(contacts.size(), 1U);
    ASSERT_LT((contacts[0].normal - normal).norm(), 1e-9);
    ASSERT_NEAR(contacts[0].depth, depth + 0.002, 1e-9);
  }
}

TEST(BallTest, StandsOnARidgeAndInAValley) {
  for (const double radius : {0.008, 0.1}) {
    for (const double aside : {-0.2, 0.0, 0.1, 0.3}) {
      const GroundSurface hill(ridge(0.6), 0.0);
      const Vector3d centre(5.0 + aside * radius, 5.02, 0.5 + 0.95 * radius);
      const SurfaceContacts on_top = collideGround(hill, ballAt(radius, centre), 0.0);
      ASSERT_EQ(on_top.size(), 1U) << aside;
      EXPECT_LT((on_top[0].normal - Vector3d(aside, 0.0, 0.95).normalized()).norm(), 1e-9);
      EXPECT_NEAR(on_top[0].depth, radius * (1.0 - std::hypot(aside, 0.95)), 1e-9);
    }
    const GroundSurface valley(ridge(-0.6), 0.0);
    const double height = radius * std::hypot(1.0, 0.6);
    const SurfaceContacts below = collideGround(valley, ballAt(radius, {5.0, 5.02, 0.5 + height - 1e-4}), 0.0);
    ASSERT_EQ(below.size(), 2U);
    EXPECT_LT((below[0].normal + below[1].normal).head<2>().norm(), 1e-9);
  }
}

TEST(BallTest, IsPushedUpHoweverDeepItIs) {
  const GroundSurface ground(ridge(0.6), 0.0);
  for (const double depth : {0.01, 0.1, 1.0}) {
    const SurfaceContacts contacts = collideGround(ground, ballAt(0.01, {5.1, 5.0, 0.44 - depth}), 0.0);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_GT(contacts[0].normal.z(), 0.5);
    EXPECT_NEAR(contacts[0].depth, 0.01 + depth * contacts[0].normal.z(), 1e-9);
  }
}

TEST(BallTest, PassesFromTheLevelGroundOntoTheTerrainWithoutASeam) {
  const GroundSurface ground(terrainOf([](double, double) { return 0.0; }, 0.05), 0.0);
  for (double x = 3.9; x < 4.1; x += 0.0013) {
    const SurfaceContacts contacts = collideGround(ground, ballAt(0.2, {x, 5.0, 0.199}), 0.0);
    ASSERT_EQ(contacts.size(), 1U) << x;
    EXPECT_LT((contacts[0].normal - Vector3d::UnitZ()).norm(), 1e-9) << x;
    EXPECT_NEAR(contacts[0].depth, 0.001, 1e-9) << x;
  }
}

TEST(CliffTest, HoldsWhatComesFromAside) {
  const GroundSurface mesa(terrainOf([](double, double) { return 0.3; }, 0.05), 0.0);
  const SurfaceContacts outside = collideGround(mesa, ballAt(0.05, {3.951, 5.0, 0.1}), 0.002);
  ASSERT_EQ(outside.size(), 1U);
  EXPECT_LT((outside[0].normal + Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_NEAR(outside[0].depth, 0.003, 1e-9);
  const GroundSurface hole(terrainOf([](double, double) { return -0.3; }, 0.05), 0.0);
  const SurfaceContacts inside = collideGround(hole, ballAt(0.05, {4.049, 5.0, -0.1}), 0.002);
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_LT((inside[0].normal - Vector3d::UnitX()).norm(), 1e-9);
  // a box with its lower edge a little in the wall
  const PlacedSolid box(shapeOf(CollisionShape::Kind::kBox, {0.05, 0.05, 0.05}),
                        {{3.951, 5.0, 0.1}, Eigen::Quaterniond::Identity()});
  for (const SurfaceContact& contact : collideGround(mesa, box, 0.0)) {
    EXPECT_LT((contact.normal + Vector3d::UnitX()).norm(), 1e-9);
    EXPECT_NEAR(contact.depth, 0.001, 1e-9);
  }
}

TEST(SolidTest, AFaceIsHeldByARidgeThatNoCornerMeets) {
  const GroundSurface ground(ridge(0.6), 0.0);
  const Pose pose{{5.0, 5.03, 0.5 + 0.05 - 0.001}, Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitZ()))};
  for (const auto kind : {CollisionShape::Kind::kBox, CollisionShape::Kind::kCylinder}) {
    SurfaceContacts contacts = collideGround(ground, PlacedSolid(shapeOf(kind, {0.06, 0.06, 0.05}), pose), 0.0);
    ASSERT_GE(contacts.size(), 2U);
    double low = 5.03;
    double high = 5.03;
    for (const SurfaceContact& contact : contacts) {
      EXPECT_LT((contact.normal - Vector3d::UnitZ()).norm(), 1e-9);
      EXPECT_NEAR(contact.depth, 0.001, 1e-9);
      EXPECT_NEAR(contact.position.x(), 5.0, 1e-9);
      low = std::min(low, contact.position.y());
      high = std::max(high, contact.position.y());
    }
    EXPECT_GT(high - low, 0.119);  // both ends, so that it does not rock along the ridge
    contacts.keepSpread(2);
    EXPECT_GT((contacts[0].position - contacts[1].position).norm(), 0.05);
  }
}

TEST(SolidTest, ACylinderLiesOnItsSide) {
  const GroundSurface ground(terrainOf([](double x, double) { return 0.3 * (x - 5.0); }, 0.05), 0.0);
  const Vector3d normal = Vector3d(-0.3, 0.0, 1.0).normalized();
  const Pose pose{Vector3d(5.01, 5.02, 0.003) + 0.039 * normal,
                  Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitX()))};
  const PlacedSolid cylinder(shapeOf(CollisionShape::Kind::kCylinder, {0.04, 0.04, 0.1}), pose);
  SurfaceContacts contacts = collideGround(ground, cylinder, 0.0);
  ASSERT_EQ(contacts.size(), 2U);
  for (const SurfaceContact& contact : contacts) {
    EXPECT_LT((contact.normal - normal).norm(), 1e-9);
    EXPECT_NEAR(contact.depth, 0.001, 1e-9);
  }
}

/// ODE's heightfield with the terrain's heights, z upwards.
class OdeHeightfield {
 public:
  explicit OdeHeightfield(const Terrain& terrain) {
    for (int j = terrain.rows() - 1; j >= 0; --j) {
      for (int i = 0; i < terrain.columns(); ++i) {
        heights_.push_back(terrain.vertex(i, j).z());
      }
    }
    const Eigen::AlignedBox3d& bounds = terrain.bounds();
    data_ = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(data_, heights_.data(), 0, bounds.sizes().x(), bounds.sizes().y(),
                                    terrain.columns(), terrain.rows(), 1.0, 0.0, 1.0, 0);
    geom_ = dCreateHeightfield(nullptr, data_, 1);
    setGeomPose(geom_, {bounds.center().x(), bounds.center().y(), 0.0},
                Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitX())));
  }
  ~OdeHeightfield() {
    dGeomDestroy(geom_);
    dGeomHeightfieldDataDestroy(data_);
  }
  OdeHeightfield(const OdeHeightfield&) = delete;
  OdeHeightfield& operator=(const OdeHeightfield&) = delete;

  /// Distance to the nearest hit of a ray; more than its length if there is none.
  double distance(const Segment& segment) const {
    const Vector3d way = segment.to - segment.from;
    const dGeomID ray = dCreateRay(nullptr, way.norm());
    dGeomRaySet(ray, segment.from.x(), segment.from.y(), segment.from.z(), way.x(), way.y(), way.z());
    std::array<dContactGeom, 64> found;
    const int count = dCollide(geom_, ray, 64, found.data(), sizeof(dContactGeom));
    double nearest = 2.0 * way.norm();
    for (int i = 0; i < count; ++i) {
      nearest = std::min(nearest, found[static_cast<std::size_t>(i)].depth);
    }
    dGeomDestroy(ray);
    return nearest;
  }

 private:
  std::vector<double> heights_;
  dHeightfieldDataID data_ = nullptr;
  dGeomID geom_ = nullptr;
};

TEST(RayTest, HitsTheSameTrianglesAsInOde) {
  unsigned long seed = 1;
  const OdeLock lock(seed);
  const auto terrain = terrainOf(
      [](double x, double y) { return 0.2 * std::sin(7.0 * x) * std::cos(5.0 * y) + 0.05 * std::sin(31.0 * x * y); },
      0.07);
  const OdeHeightfield ode(*terrain);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-0.95, 0.95);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto somewhere = [&](double height) { return Vector3d(5.0 + part(random), 5.0 + part(random), height); };
    const Segment ray{somewhere(0.3), somewhere(0.25 * part(random))};
    const double length = (ray.to - ray.from).norm();
    const double expected = ode.distance(ray);
    const double fraction = terrain->closestHit(ray);
    if (expected < length) {
      ASSERT_NEAR(fraction * length, expected, 1e-9) << "ray " << i;
      ++hits;
    } else {
      ASSERT_GT(fraction, 1.0) << "ray " << i;
    }
  }
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
