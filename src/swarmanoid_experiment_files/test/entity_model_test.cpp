#include "swarmanoid_space/models/entity_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/state/joints.hpp"

namespace swarmanoid {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

EntityModel modelOf(const CollisionShape& shape) {
  EntityModel model;
  model.shapes.push_back(shape);
  model.measureShapes();
  return model;
}

TEST(EntityModelTest, BlockHasItsOriginAtItsCentre) {
  const auto block = blockModel({0.5, 0.05, 0.4});
  EXPECT_EQ(block->type, "block");
  EXPECT_EQ(block->title, "Block");
  ASSERT_EQ(block->shapes.size(), 1U);
  EXPECT_EQ(block->shapes[0].kind, CollisionShape::Kind::kBox);
  EXPECT_EQ(block->shapes[0].half_extent, Vector3d(0.25, 0.025, 0.2));
  EXPECT_EQ(block->shapes[0].position, Vector3d::Zero());
  EXPECT_DOUBLE_EQ(block->lowest, -0.2);
  EXPECT_DOUBLE_EQ(block->highest, 0.2);
  EXPECT_DOUBLE_EQ(block->bounding_radius, std::sqrt(0.25 * 0.25 + 0.025 * 0.025 + 0.2 * 0.2));
  EXPECT_FALSE(block->is_robot);
  EXPECT_FALSE(block->is_movable);
  EXPECT_FALSE(block->gripping_radius.has_value());
}

TEST(EntityModelTest, BlockWithAMassCanBeMoved) {
  const auto block = blockModel({0.6, 0.3, 0.2}, 12.0);
  EXPECT_TRUE(block->is_movable);
  EXPECT_EQ(block->mass, 12.0);
  EXPECT_EQ(block->centre_of_mass, Vector3d::Zero());
  EXPECT_DOUBLE_EQ(block->origin_height, 0.1);
  EXPECT_TRUE(block->inertia.diagonal().isApprox(Vector3d(0.09 + 0.04, 0.36 + 0.04, 0.36 + 0.09), 1e-12));
  EXPECT_EQ(blockModel({0.6, 0.3, 0.2})->mass, 0.0);
}

TEST(EntityModelTest, PartsAddUpToOneMass) {
  EntityModel model;
  const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
  model.addMass({1.0, {0.0, 0.0, 1.0}, none});
  model.addMass({3.0, {0.4, 0.0, 1.0}, none});
  EXPECT_DOUBLE_EQ(model.mass, 4.0);
  EXPECT_TRUE(model.centre_of_mass.isApprox(Vector3d(0.3, 0.0, 1.0), 1e-12));
  // two points 0.4 m apart: reduced mass times distance squared, across the line between them
  EXPECT_TRUE(model.inertia.isApprox(Vector3d(0.0, 0.12, 0.12).asDiagonal().toDenseMatrix(), 1e-12));
}

/// The solid is turned by 30 degrees about its y axis, so both its x axis and its z axis have a component along body z.
TEST(EntityModelTest, ASolidReachesAsFarAlongADirectionAsItsFarthestPoint) {
  CollisionShape shape;
  shape.position = {0.3, -0.2, 0.7};
  shape.half_extent = {0.11, 0.11, 0.27};
  shape.orientation = AngleAxisd(M_PI / 6.0, Vector3d::UnitY());
  const double half_of_three = std::sqrt(3.0) / 2.0;
  EXPECT_NEAR(shape.reachAlong(Vector3d::UnitZ()), 0.11 * 0.5 + 0.27 * half_of_three, 1e-12);
  EXPECT_NEAR(shape.reachAlong(-Vector3d::UnitX()), 0.11 * half_of_three + 0.27 * 0.5, 1e-12);
  EXPECT_NEAR(shape.reachAlong(Vector3d::UnitY()), 0.11, 1e-12);
  const Vector3d slanted = Vector3d(0.48, 0.6, 0.64);
  const Vector3d in_shape = shape.orientation.conjugate() * slanted;
  EXPECT_NEAR(shape.reachAlong(slanted),
              0.11 * std::sqrt(1.0 - in_shape.z() * in_shape.z()) + 0.27 * std::abs(in_shape.z()), 1e-12);
  shape.kind = CollisionShape::Kind::kBox;
  shape.half_extent = {0.11, 0.05, 0.27};
  EXPECT_NEAR(shape.reachAlong(Vector3d::UnitZ()), 0.11 * 0.5 + 0.27 * half_of_three, 1e-12);
  EXPECT_NEAR(shape.reachAlong(Vector3d::UnitY()), 0.05, 1e-12);
  shape.kind = CollisionShape::Kind::kSphere;
  EXPECT_EQ(shape.reachAlong(slanted), 0.11);
}

TEST(EntityModelTest, PreyStandsOnItsOriginAndCanBeGripped) {
  const auto prey = cylindricPreyModel(0.1, 0.16);
  EXPECT_EQ(prey->type, "cylindric_prey");
  ASSERT_EQ(prey->shapes.size(), 1U);
  EXPECT_EQ(prey->shapes[0].kind, CollisionShape::Kind::kCylinder);
  EXPECT_EQ(prey->shapes[0].half_extent, Vector3d(0.1, 0.1, 0.08));
  EXPECT_DOUBLE_EQ(prey->lowest, 0.0);
  EXPECT_DOUBLE_EQ(prey->highest, 0.16);
  EXPECT_DOUBLE_EQ(prey->bounding_radius, std::hypot(0.1, 0.16));
  EXPECT_TRUE(prey->is_movable);
  EXPECT_FALSE(prey->is_robot);
  EXPECT_EQ(prey->gripping_radius, 0.1);
  EXPECT_EQ(prey->mass, kPreyMass);
  EXPECT_EQ(prey->origin_height, 0.0);
  EXPECT_TRUE(prey->centre_of_mass.isApprox(Vector3d(0.0, 0.0, 0.08)));
  EXPECT_DOUBLE_EQ(prey->inertia(2, 2), kPreyMass * 0.1 * 0.1 / 2.0);
  ASSERT_EQ(prey->led_positions.size(), 1U);
  EXPECT_EQ(prey->led_positions[0], Vector3d(0.0, 0.0, 0.08));
}

TEST(EntityModelTest, LightHasNoShapeAndOneLed) {
  const auto light = lightModel();
  EXPECT_EQ(light->type, "light");
  EXPECT_TRUE(light->shapes.empty());
  EXPECT_EQ(light->bounding_radius, 0.0);
  ASSERT_EQ(light->led_positions.size(), 1U);
  EXPECT_EQ(light->led_positions[0], Vector3d::Zero());
  ASSERT_EQ(light->properties.size(), 1U);
  EXPECT_EQ(light->findProperty("intensity"), 0);
  EXPECT_EQ(light->findProperty("intensit"), -1);
  EXPECT_EQ(light->properties[0].initial, 1.0);
  EXPECT_EQ(lightModel(0.25)->properties[0].initial, 0.25);
}

TEST(EntityModelTest, LampsAndPreysHaveAColourOfTheirOwn) {
  EXPECT_TRUE(lightModel()->hasColor());
  EXPECT_TRUE(cylindricPreyModel(0.1, 0.1)->hasColor());
  EXPECT_FALSE(blockModel({1.0, 1.0, 1.0})->hasColor()) << "cameras see none";
  EXPECT_FALSE(robotModel("footbot")->hasColor()) << "its LEDs have";
}

TEST(EntityModelTest, NoShapeMeasuresZero) {
  EntityModel model;
  model.lowest = model.highest = model.bounding_radius = 7.0;
  model.measureShapes();
  EXPECT_EQ(model.lowest, 0.0);
  EXPECT_EQ(model.highest, 0.0);
  EXPECT_FALSE(std::signbit(model.highest));
  EXPECT_EQ(model.bounding_radius, 0.0);
}

TEST(EntityModelTest, RolledCylinderIsAsHighAsItIsWide) {
  CollisionShape wheel;
  wheel.half_extent = {0.029, 0.029, 0.01};
  wheel.position = {0.0, 0.07, 0.029};
  wheel.orientation = AngleAxisd(M_PI / 2, Vector3d::UnitX());
  const EntityModel model = modelOf(wheel);
  EXPECT_NEAR(model.lowest, 0.0, 1e-15);
  EXPECT_NEAR(model.highest, 0.058, 1e-15);
  EXPECT_NEAR(model.bounding_radius, std::hypot(0.08, 0.058), 1e-15);
}

TEST(EntityModelTest, BoxOnItsEdgeIsHigherThanOnItsFace) {
  CollisionShape box;
  box.kind = CollisionShape::Kind::kBox;
  box.half_extent = {1.0, 1.0, 1.0};
  box.position = {0.0, 0.0, 2.0};
  box.orientation = AngleAxisd(M_PI / 4, Vector3d::UnitX());
  const EntityModel model = modelOf(box);
  EXPECT_NEAR(model.lowest, 2.0 - std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(model.highest, 2.0 + std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(model.bounding_radius, std::hypot(2.0 + std::sqrt(2.0), 1.0), 1e-15);
}

TEST(EntityModelTest, ASilhouetteIsWholeOnlyOfAnUprightCylinderAboutTheAxis) {
  CollisionShape cylinder;
  cylinder.half_extent = {0.3, 0.3, 0.2};
  cylinder.position = {0.0, 0.0, 1.1};
  const EntityModel::Silhouette whole = modelOf(cylinder).silhouettes.at(0);
  EXPECT_TRUE(whole.is_whole);
  EXPECT_NEAR(whole.radius, 0.3, 1e-15);
  EXPECT_NEAR(whole.low, 0.9, 1e-15);
  EXPECT_NEAR(whole.high, 1.3, 1e-15);

  cylinder.position.x() = 0.4;
  const EntityModel::Silhouette beside = modelOf(cylinder).silhouettes.at(0);
  EXPECT_FALSE(beside.is_whole);
  EXPECT_NEAR(beside.radius, 0.7, 1e-15);

  cylinder.position.x() = 0.0;
  cylinder.orientation = AngleAxisd(M_PI / 2, Vector3d::UnitY());
  const EntityModel::Silhouette rolled = modelOf(cylinder).silhouettes.at(0);
  EXPECT_FALSE(rolled.is_whole);
  EXPECT_NEAR(rolled.high, 1.4, 1e-15);
  EXPECT_NEAR(rolled.radius, std::hypot(0.2, 0.3), 1e-15) << "to the rim of its faces";
}

TEST(EntityModelTest, SphereReachesItsRadiusEverywhere) {
  CollisionShape sphere;
  sphere.kind = CollisionShape::Kind::kSphere;
  sphere.half_extent.setConstant(0.5);
  sphere.position = {3.0, 0.0, 4.0};
  const EntityModel model = modelOf(sphere);
  EXPECT_DOUBLE_EQ(model.lowest, 3.5);
  EXPECT_DOUBLE_EQ(model.highest, 4.5);
  EXPECT_DOUBLE_EQ(model.bounding_radius, 5.5);
}

TEST(EntityModelTest, AllShapesAreMeasuredTogether) {
  EntityModel model;
  model.shapes.resize(2);
  model.shapes[0].half_extent = {1.0, 1.0, 0.5};
  model.shapes[1].half_extent = {0.1, 0.1, 0.1};
  model.shapes[1].position = {0.0, 0.0, 3.0};
  model.measureShapes();
  EXPECT_DOUBLE_EQ(model.lowest, -0.5);
  EXPECT_DOUBLE_EQ(model.highest, 3.1);
  EXPECT_DOUBLE_EQ(model.bounding_radius, std::hypot(0.1, 3.1));
}

/// A sphere at the end of two links, the second folded back on the first.
EntityModel foldedArm(const Vector3d& shoulder, const Vector3d& axis) {
  EntityModel model;
  EntityModel::Joint joint;
  joint.axis = axis;
  joint.frame.position = shoulder;
  model.joints.push_back(joint);
  joint.carrier = 0;
  joint.frame.position = shoulder + Vector3d(0.3, 0.0, 0.0);
  model.joints.push_back(joint);
  CollisionShape hand;
  hand.kind = CollisionShape::Kind::kSphere;
  hand.half_extent.setConstant(0.05);
  hand.position = shoulder + Vector3d(0.1, 0.0, 0.0);
  hand.joint = 1;
  model.shapes.push_back(hand);
  model.measureShapes();
  return model;
}

TEST(EntityModelTest, AnArmReachesAsFarAsItStretches) {
  const EntityModel model = foldedArm({0.0, 0.0, 0.5}, Vector3d::UnitY());
  EXPECT_DOUBLE_EQ(model.bounding_radius, std::hypot(0.1, 0.5) + 0.05);
  EXPECT_DOUBLE_EQ(model.moving_reach, 0.5 + 0.3 + 0.2 + 0.05);
  EXPECT_FALSE(model.joints_keep_outline);
  EXPECT_FALSE(foldedArm({0.1, 0.0, 0.5}, Vector3d::UnitZ()).joints_keep_outline) << "upright, but not on body z";
}

TEST(EntityModelTest, ATurretLeavesTheOutlineAsItIs) {
  const auto footbot = robotModel("footbot");
  EXPECT_TRUE(footbot->joints_keep_outline);
  EXPECT_EQ(footbot->moving_reach, footbot->bounding_radius) << "to the last bit";
  EXPECT_EQ(blockModel({0.3, 0.4, 0.5})->moving_reach, blockModel({0.3, 0.4, 0.5})->bounding_radius);
}

TEST(EntityModelTest, AHandbotsArmsRiseOverItAndStayInItsMovingReach) {
  const auto handbot = robotModel("handbot");
  EXPECT_FALSE(handbot->joints_keep_outline);
  std::mt19937 random(5);
  double highest = 0.0;
  for (int i = 0; i < 500; ++i) {
    std::vector<JointState> states(handbot->joints.size());
    for (std::size_t k = 0; k < states.size(); ++k) {
      const EntityModel::Joint& joint = handbot->joints[k];
      states[k].angle = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
    }
    const auto posed = posedModel(handbot, Span<const JointState>(states.data(), states.size()));
    ASSERT_LE(posed->bounding_radius, handbot->moving_reach);
    highest = std::max(highest, posed->highest);
  }
  EXPECT_GT(highest, handbot->highest + 0.01);
}

TEST(EntityModelTest, NamesTheMountThatIsMissing) {
  EntityModel model;
  model.type = "footbot";
  model.mounts["camera"].position = {0.0, 0.0, 0.28};
  EXPECT_EQ(model.mount("camera").position.z(), 0.28);
  try {
    model.mount("telescope");
    FAIL();
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "entity type 'footbot' has no mount 'telescope'");
  }
}

}  // namespace
}  // namespace swarmanoid
