// A footbot with a turned turret that holds a prey is handed from engine to engine; state and grip are kept.
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "carry_out.hpp"
#include "dynamics2d/dynamics2d.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "kinematics2d/kinematics2d.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

class Journey {
 public:
  Journey() {
    engines_ = {std::make_unique<kinematics2d::Kinematics2d>(), std::make_unique<dynamics2d::Dynamics2d>(),
                std::make_unique<dynamics3d::Dynamics3d>()};
    space.size = {10.0, 10.0, 2.0};
    space.clocktick = std::chrono::milliseconds(100);
    for (const auto& engine : engines_) {
      Configuration configuration("engine", "", {});
      configuration.set("subclock", "10");
      engine->configure("engine", configuration);
    }
    prey = add(cylindricPreyModel(0.1, 0.12), {2.0, 2.22, 0.0});
    footbot = add(robotModel("footbot"), {2.0, 2.0, 0.0});
    space.actuation.bank<FootbotWheels>().add(footbot);
    space.actuation.bank<FootbotGripper>().add(footbot);
    space.actuation.bank<FootbotTurret>().add(footbot);
    enter();
  }

  void tick() {
    test::carryOut(space);
    engine().move(space, MoveAccess(space), space.clocktick);
    engine().connect(space, ConnectAccess(space));
  }
  /// Hands both entities to the next engine.
  void handOver() {
    for (const Row row : {prey, footbot}) {
      engine().remove(space, row);
    }
    now_ = (now_ + 1) % engines_.size();
    enter();
  }
  FootbotTurret& turret() { return *space.actuation.bank<FootbotTurret>().find(footbot); }
  Pose& pose(Row row) { return space.entities.pose[row]; }
  Twist& twist(Row row) { return space.entities.twist[row]; }
  JointState& joint() { return space.joints[footbot][0]; }
  /// Position of the prey in the turret's frame.
  Vector3d place() {
    const Pose& robot = pose(footbot);
    const Eigen::AngleAxisd turn(joint().angle, Vector3d::UnitZ());
    return (robot.orientation * turn).conjugate() * (pose(prey).position - robot.position);
  }

  Space space;
  Row prey = kNoRow;
  Row footbot = kNoRow;

 private:
  Engine& engine() { return *engines_[now_]; }
  Row add(const std::shared_ptr<const EntityModel>& model, const Vector3d& position) {
    const Row row = space.entities.add(model->type, model, {position, Eigen::Quaterniond::Identity()}, colors::kBlack);
    return row;
  }
  void enter() {
    test::carryOut(space);
    for (const Row row : {prey, footbot}) {
      const auto posed = posedModel(space.entities.model[row], space.joints[row]);
      ASSERT_EQ(engine().invalidPoseReason(*posed, space.entities.pose[row]), "");
      ASSERT_EQ(engine().overlap(*posed, space.entities.pose[row], Span<const Row>()), kNoRow);
      space.mover[row] = &engine();
      engine().add(space, row, Role::kMove);
    }
  }

  std::array<std::unique_ptr<Engine>, 3> engines_;
  std::size_t now_ = 0;
};

TEST(TurretHandoverTest, AngleSpeedGripAndPosesComeAlong) {
  Journey journey;
  journey.turret().holdAngle(M_PI / 2.0);
  for (int i = 0; i < 7; ++i) {
    journey.tick();
  }
  journey.space.actuation.bank<FootbotGripper>().find(journey.footbot)->close();
  journey.tick();
  ASSERT_EQ(journey.space.structure.grippedBy(journey.footbot), journey.prey);
  const Vector3d at_first = journey.place();
  EXPECT_NEAR(at_first.x(), 0.22, 1e-9);
  journey.turret().turnAt(0.4);
  journey.space.actuation.bank<FootbotWheels>().find(journey.footbot)->setAngularVelocity(2.0, 3.0);
  for (int i = 0; i < 30; ++i) {
    journey.tick();
    const JointState joint = journey.joint();
    std::array<Pose, 2> poses{journey.pose(journey.prey), journey.pose(journey.footbot)};
    std::array<Twist, 2> twists{journey.twist(journey.prey), journey.twist(journey.footbot)};
    EXPECT_NEAR(joint.speed, 0.4, 0.02) << "tick " << i;
    journey.handOver();
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(journey.joint().angle, joint.angle);
    EXPECT_EQ(journey.joint().speed, joint.speed);
    for (const std::size_t k : {0U, 1U}) {
      const Row row = k == 0 ? journey.prey : journey.footbot;
      EXPECT_EQ(journey.pose(row).position, poses[k].position);
      EXPECT_EQ(journey.pose(row).orientation.coeffs(), poses[k].orientation.coeffs());
      EXPECT_EQ(journey.twist(row).linear, twists[k].linear);
      EXPECT_EQ(journey.twist(row).angular, twists[k].angular);
    }
    ASSERT_EQ(journey.space.structure.grippedBy(journey.footbot), journey.prey);
    EXPECT_LT((journey.place() - at_first).norm(), 2e-3) << "tick " << i;
  }
  EXPECT_NEAR(journey.joint().angle, M_PI / 2.0 + 30 * 0.1 * 0.4, 0.03);
}

TEST(TurretHandoverTest, RobotsWithoutTurretAreRefusedByName) {
  auto bare = std::make_shared<EntityModel>(*robotModel("footbot"));
  bare->joints.clear();
  for (const char* device : {FootbotTurret::kType, FootbotTurretState::kType}) {
    const std::string expected =
        "device '" + std::string(device) + "' cannot be simulated: a robot of this type has no joint 'turret'";
    EXPECT_EQ(kinematics2d::Kinematics2d().unsupportedReason(*bare, test::uses({device})), expected);
    EXPECT_EQ(dynamics2d::Dynamics2d().unsupportedReason(*bare, test::uses({device})), expected);
    EXPECT_EQ(dynamics3d::Dynamics3d().unsupportedReason(*bare, test::uses({device})), expected);
    EXPECT_EQ(dynamics3d::Dynamics3d().unsupportedReason(*robotModel("footbot"), test::uses({device})), "");
  }
}

}  // namespace
}  // namespace swarmanoid
