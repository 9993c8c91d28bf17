// Joints: from the URDF to the poses of links, and attachments of robots.
#include <gtest/gtest.h>

#include <cmath>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/space.hpp"
#include "swarmanoid_space/state/joints.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

TEST(JointsTest, AHandbotHasTwoArmsOfThreeJoints) {
  const auto handbot = robotModel("handbot");
  ASSERT_EQ(handbot->joints.size(), 6U);
  for (const char* side : {"left", "right"}) {
    const int shoulder = handbot->findJoint(std::string(side) + "_shoulder");
    const int elbow = handbot->findJoint(std::string(side) + "_elbow");
    const int wrist = handbot->findJoint(std::string(side) + "_wrist");
    ASSERT_GE(shoulder, 0);
    ASSERT_GT(elbow, shoulder);
    ASSERT_GT(wrist, elbow);
    const auto& joints = handbot->joints;
    EXPECT_EQ(joints[static_cast<std::size_t>(shoulder)].carrier, -1);
    EXPECT_EQ(joints[static_cast<std::size_t>(elbow)].carrier, shoulder);
    EXPECT_EQ(joints[static_cast<std::size_t>(wrist)].carrier, elbow);
    EXPECT_EQ(joints[static_cast<std::size_t>(shoulder)].lower, -1.57);
    EXPECT_EQ(joints[static_cast<std::size_t>(shoulder)].upper, 0.7);
    EXPECT_EQ(joints[static_cast<std::size_t>(elbow)].max_effort, 5.0);
    EXPECT_EQ(joints[static_cast<std::size_t>(wrist)].max_speed, 2.0);
    EXPECT_TRUE(joints[static_cast<std::size_t>(elbow)].axis.isApprox(Vector3d::UnitZ()));
  }
  EXPECT_EQ(handbot->findJoint("neck"), -1);
}

TEST(JointsTest, PartsWeighWhatTheWholeWeighs) {
  const auto handbot = robotModel("handbot");
  Inertial whole = handbot->body_part;
  for (const EntityModel::Joint& joint : handbot->joints) {
    EXPECT_GT(joint.part.mass, 0.0) << joint.name;
    whole.add(joint.part);
  }
  EXPECT_NEAR(whole.mass, 2.9, 1e-9);
  EXPECT_NEAR(whole.mass, handbot->mass, 1e-12);
  EXPECT_TRUE(whole.centre_of_mass.isApprox(handbot->centre_of_mass, 1e-12));
  EXPECT_TRUE(whole.inertia.isApprox(handbot->inertia, 1e-12));
}

TEST(JointsTest, WheelsAreNoJoints) { EXPECT_EQ(robotModel("footbot")->findJoint("left_wheel"), -1); }

TEST(JointsTest, LinksAreWhereTheirJointsTurnThem) {
  const auto handbot = robotModel("handbot");
  std::vector<JointState> states(handbot->joints.size());
  const Vector3d shoulder = handbot->mount("left_upper_arm").position;
  const Vector3d hand = handbot->mount("left_hand").position;
  EXPECT_TRUE(placeOf(*handbot, states, "left_hand").position.isApprox(hand));

  // with the shoulder a quarter turn up, points ahead of it are above it
  states[handbot->findJoint("left_shoulder")].angle = -M_PI / 2.0;
  const double reach = (hand - shoulder).norm();
  EXPECT_TRUE(placeOf(*handbot, states, "left_hand").position.isApprox(shoulder + reach * Vector3d::UnitZ(), 1e-9));
  EXPECT_TRUE(placeOf(*handbot, states, "right_hand").position.isApprox(handbot->mount("right_hand").position));

  // then the elbow a quarter turn to the left, about an axis that the shoulder has turned to point backwards
  states[handbot->findJoint("left_elbow")].angle = M_PI / 2.0;
  const double upper = (handbot->mount("left_forearm").position - shoulder).norm();
  const Mount place = placeOf(*handbot, states, "left_hand");
  EXPECT_TRUE(place.position.isApprox(shoulder + Vector3d(0.0, reach - upper, upper), 1e-9));
  EXPECT_TRUE((place.orientation * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-9));
}

TEST(JointsTest, AFootbotHasATurretThatCarriesTheGripper) {
  const auto footbot = robotModel("footbot");
  ASSERT_EQ(footbot->joints.size(), 1U);
  const EntityModel::Joint& turret = footbot->joints[0];
  EXPECT_EQ(turret.name, "turret");
  EXPECT_EQ(turret.axis, Vector3d::UnitZ());
  EXPECT_TRUE(std::isinf(turret.lower) && std::isinf(turret.upper));
  EXPECT_EQ(turret.max_speed, 3.0);
  EXPECT_EQ(turret.max_effort, 2.0);
  EXPECT_EQ(turret.part.mass, 0.0);
  EXPECT_EQ(footbot->mount("gripper_tip").joint, 0);
  EXPECT_EQ(footbot->mount("gripper_tip").position, Vector3d(0.11, 0.0, 0.05));
  for (const CollisionShape& shape : footbot->shapes) {
    EXPECT_EQ(shape.joint, shape.kind == CollisionShape::Kind::kBox ? 0 : -1);  // only the gripper is a box
  }
  for (const char* mount : {"proximity_0", "led_0", "camera", "gripping_strip"}) {
    EXPECT_EQ(footbot->mount(mount).joint, -1) << mount;
  }
}

TEST(JointsTest, AModelIsPosedAsItsJointsAre) {
  const auto footbot = robotModel("footbot");
  std::vector<JointState> states(footbot->joints.size());
  EXPECT_EQ(posedModel(footbot, states), footbot);
  states[0].angle = M_PI / 2.0;
  const auto posed = posedModel(footbot, states);
  ASSERT_EQ(posed->shapes.size(), footbot->shapes.size());
  EXPECT_EQ(posed->shapes[0].position, footbot->shapes[0].position);
  EXPECT_TRUE(posed->shapes.back().position.isApprox(Vector3d(0.0, 0.09, 0.05), 1e-12));
  EXPECT_TRUE((posed->shapes.back().orientation * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-12));
  EXPECT_NEAR(posed->horizontal_radius, footbot->horizontal_radius, 1e-12);
}

class AttachmentsTest : public ::testing::Test {
 protected:
  AttachmentsTest() {
    for (const char* name : {"climber", "shelf", "book", "helper"}) {
      const bool is_fixed = name == std::string("shelf");
      auto model = std::make_shared<EntityModel>(*blockModel(Vector3d::Ones(), is_fixed ? 0.0 : 1.0));
      for (const char* holder : {"rope", "left hand", "right hand"}) {
        model->holders.push_back({holder, EntityModel::Holder::Kind::kSuction, "", 0.0});
      }
      entities.add(name, model, Pose{}, Color{});
    }
  }

  static constexpr std::size_t kRope = 0;
  static constexpr std::size_t kLeftHand = 1;
  static constexpr std::size_t kRightHand = 2;
  static constexpr Row kClimber{0};
  static constexpr Row kShelf{1};
  static constexpr Row kBook{2};
  static constexpr Row kHelper{3};
  Entities entities;
  StructuralTree structure{entities.columns};
  Attachments attachments{entities};
};

TEST_F(AttachmentsTest, EachHolderHoldsOneThing) {
  attachments.attach(kClimber, kRope, {kShelf, Vector3d::Zero(), 0.0, 0.0});
  attachments.attach(kClimber, kLeftHand, {kBook, Vector3d::Zero(), 0.0, 0.0});
  EXPECT_TRUE(attachments.isAttached(kClimber, kRope));
  EXPECT_FALSE(attachments.isAttached(kClimber, kRightHand));
  EXPECT_TRUE(attachments.isHeld(kBook));
  EXPECT_FALSE(attachments.isAttached(kBook));
  attachments.detach(kClimber, kRope);
  EXPECT_TRUE(attachments.isAttached(kClimber));
  attachments.isolate(kBook);
  EXPECT_FALSE(attachments.isAttached(kClimber));
}

TEST_F(AttachmentsTest, WhatHangsTogetherAndMovesIsConnected) {
  attachments.attach(kClimber, kRope, {kShelf, Vector3d::Zero(), 0.0, 0.0});
  attachments.attach(kClimber, kLeftHand, {kBook, Vector3d::Zero(), 0.0, 0.0});
  structure.connect(kHelper, kClimber);
  const std::vector<Row> all{kClimber, kHelper, kBook};
  EXPECT_EQ(connectedTo(entities, structure, attachments, kClimber), all);
  EXPECT_EQ(connectedTo(entities, structure, attachments, kHelper), all);
  EXPECT_EQ(connectedTo(entities, structure, attachments, kBook), (std::vector<Row>{kBook, kClimber, kHelper}));
}

}  // namespace
}  // namespace swarmanoid
