// Reasons why engines do not take entities in a state that they cannot continue.
#include <gtest/gtest.h>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "kinematics2d/kinematics2d.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid {
namespace {

class UnsupportedStateTest : public ::testing::Test {
 protected:
  UnsupportedStateTest() {
    space.size = {10.0, 10.0, 3.0};
    for (Engine* engine : std::initializer_list<Engine*>{&kinematics, &forces, &spatial}) {
      engine->configure("engine", Configuration("engine", "", {}));
    }
    handbot = add("handbot", robotModel("handbot"), {2.0, 2.0, 0.0});
    footbot = add("footbot", robotModel("footbot"), {3.0, 2.0, 0.0});
    ceiling = add("ceiling", blockModel({5.0, 5.0, 0.1}, 0.0, true), {2.5, 2.5, 2.5});
  }
  Row add(const std::string& name, const std::shared_ptr<const EntityModel>& model, const Eigen::Vector3d& position) {
    const Row row = space.entities.add(name, model, {position, Eigen::Quaterniond::Identity()}, colors::kBlack);
    return row;
  }

  Space space;
  kinematics2d::Kinematics2d kinematics;
  dynamics2d::Dynamics2d forces;
  dynamics3d::Dynamics3d spatial;
  Row handbot = kNoRow;
  Row footbot = kNoRow;
  Row ceiling = kNoRow;
};

TEST_F(UnsupportedStateTest, OfWhoHoldsOnToSomething) {
  constexpr std::size_t kRope = 2;  // index of its holder
  space.attachments.attach(handbot, kRope, {ceiling, Eigen::Vector3d::Zero(), 1.0, 0.0});
  const std::string in_a_plane = "holds on to something by its rope, which this engine cannot hold";
  EXPECT_EQ(kinematics.unsupportedStateReason(space, handbot), in_a_plane);
  EXPECT_EQ(forces.unsupportedStateReason(space, handbot), in_a_plane);
  EXPECT_EQ(spatial.unsupportedStateReason(space, handbot),
            "its rope holds on to 'ceiling', which is not in this engine");
  spatial.add(space, ceiling, Role::kMove);
  EXPECT_EQ(spatial.unsupportedStateReason(space, handbot), "");
  EXPECT_EQ(forces.unsupportedStateReason(space, ceiling), "") << "it is held, and holds nothing";
}

TEST_F(UnsupportedStateTest, OfWhoseArmsAreRaised) {
  JointState& shoulder = space.joints[handbot][robotModel("handbot")->findJoint("left_shoulder")];
  for (const double angle : {0.01, 0.1}) {
    shoulder.angle = angle;
    const std::string expected = angle < 0.02 ? "" : "its joint 'left_shoulder' is not at zero";
    EXPECT_EQ(kinematics.unsupportedStateReason(space, handbot), expected);
    EXPECT_EQ(forces.unsupportedStateReason(space, handbot), expected);
    EXPECT_EQ(spatial.unsupportedStateReason(space, handbot), "");
  }
}

TEST_F(UnsupportedStateTest, TurretsMayStandAnyhow) {
  space.joints[footbot][0].angle = 2.0;
  EXPECT_EQ(kinematics.unsupportedStateReason(space, footbot), "");
  EXPECT_EQ(forces.unsupportedStateReason(space, footbot), "");
  EXPECT_EQ(spatial.unsupportedStateReason(space, footbot), "");
}

}  // namespace
}  // namespace swarmanoid
