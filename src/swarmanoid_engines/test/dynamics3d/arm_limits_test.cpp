// Joints of handbots at the ends of their range, with any command and any load.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "handbot_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr int kSecond = 100;  // ticks, each of one step: the test sees every step

class ArmsWorld : public HandbotWorld {
 public:
  explicit ArmsWorld(const std::string& suction_strength = "30")
      : HandbotWorld({{"subclock", "1"}, {"suction_strength", suction_strength}}) {
    space.clocktick = std::chrono::milliseconds(10);
  }

  double& commanded(int joint) {
    HandbotArms& all = arms(robot);
    const std::array<double*, 6> angles{&all.left.shoulder,  &all.left.elbow,  &all.left.wrist,
                                        &all.right.shoulder, &all.right.elbow, &all.right.wrist};
    return *angles[static_cast<std::size_t>(joint)];
  }
  static const EntityModel::Joint& joint(int index) {
    const char* name = HandbotArmsState::kNames[static_cast<std::size_t>(index)];
    return robotModel("handbot")->joints[static_cast<std::size_t>(indexOf(name))];
  }
  const JointState& state(int index) const {
    return space.joints[robot][indexOf(HandbotArmsState::kNames[static_cast<std::size_t>(index)])];
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      step();
      for (int k = 0; k < 6; ++k) {
        fastest = std::max(fastest, std::abs(state(k).speed) / joint(k).max_speed);
      }
      strayed = std::max(strayed, (pose(robot).position - start).norm());
    }
  }

  double fastest = 0.0;  // largest speed in units of the joints' limits
  double strayed = 0.0;  // m, of the robot
  Vector3d start{2.0, 2.0, 0.0};
  Row robot = addHandbot(flatPose(2.0, 2.0));
};

/// Commands to a joint: far and a little beyond its limits, at them, and a little and far within them.
std::array<double, 9> commandsFor(const EntityModel::Joint& joint) {
  return {-10.0, joint.upper + 0.01, joint.lower,        0.37, joint.upper, joint.lower + 0.013,
          10.0,  joint.lower - 0.01, joint.upper - 0.013};
}

void expectToRest(const ArmsWorld& world, int joint, double command) {
  const EntityModel::Joint& limits = ArmsWorld::joint(joint);
  const double target = std::clamp(command, limits.lower, limits.upper);
  EXPECT_NEAR(world.state(joint).angle, target, 0.01 * std::abs(target)) << limits.name << " commanded " << command;
  EXPECT_NEAR(world.state(joint).speed, 0.0, 1e-3) << limits.name << " commanded " << command;
}

class ArmLimitsTest : public testing::TestWithParam<int> {};

TEST_P(ArmLimitsTest, AJointRestsWhereItIsToldOrAtItsEnd) {
  const int joint = GetParam();
  for (const double from : commandsFor(ArmsWorld::joint(joint))) {
    ArmsWorld world;
    world.commanded(joint) = from;
    world.run(4 * kSecond);
    for (const double command : commandsFor(ArmsWorld::joint(joint))) {
      world.commanded(joint) = command;
      world.run(4 * kSecond);
      expectToRest(world, joint, command);
    }
    EXPECT_LT(world.fastest, 1.05) << "from " << from;
    EXPECT_LT(world.strayed, 0.01) << "from " << from;
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, ArmLimitsTest, testing::Range(0, 6));

TEST(ArmLimitsTest, AllJointsAtOnceBetweenTheirExtremes) {
  for (const int period : {7, 40, 313}) {
    ArmsWorld world;
    for (int i = 0; i < 20 * kSecond; i += period) {
      for (int k = 0; k < 6; ++k) {
        world.commanded(k) = (i / period + k) % 2 == 0 ? 10.0 : -10.0;
      }
      world.run(period);
    }
    world.run(4 * kSecond);
    for (int k = 0; k < 6; ++k) {
      expectToRest(world, k, world.commanded(k));
    }
    EXPECT_LT(world.fastest, 1.05) << "period " << period;
    EXPECT_LT(world.strayed, 0.01) << "period " << period;
  }
}

TEST(ArmLimitsTest, WithALoadInTheHand) {
  for (const double mass : {0.1, 0.4}) {
    for (int joint = 0; joint < 3; ++joint) {
      ArmsWorld world;
      const Row box = world.addBlock({0.06, 0.06, 0.06}, mass, flatPose(2.236, 2.11, 0.0, 0.15));
      world.hands(world.robot).left = true;
      world.run(1);
      ASSERT_EQ(world.held(world.robot, kLeftHand).held, box);
      for (const double command : commandsFor(ArmsWorld::joint(joint))) {
        world.commanded(joint) = joint == 0 ? std::min(command, 0.3) : command;  // above the ground
        world.run(4 * kSecond);
        expectToRest(world, joint, world.commanded(joint));
      }
      EXPECT_TRUE(world.space.attachments.isAttached(world.robot));
      EXPECT_LT(world.fastest, 1.05) << mass << " kg, joint " << joint;
      EXPECT_LT(world.strayed, 0.01) << mass << " kg, joint " << joint;
    }
  }
}

/// A handbot on a pedestal, held down by a lid, with a load beyond the torque of its motors.
struct Overloaded : ArmsWorld {
  Overloaded() : ArmsWorld("200") {
    addBlock({0.2, 0.28, 0.4}, 0.0, flatPose(1.95, 2.0, 0.0, 0.2));
    place(robot, flatPose(2.0, 2.0, 0.0, 0.4));
    addBlock({0.3, 0.29, 0.1}, 0.0, flatPose(1.945, 2.0, 0.0, 0.7405));
  }
};

TEST(ArmLimitsTest, AStopHoldsWhatIsTooHeavyForTheMotor) {
  Overloaded world;
  const Row box = world.addBlock({0.06, 0.06, 0.06}, 4.0, flatPose(2.236, 2.11, 0.0, 0.55));
  world.hands(world.robot).left = true;
  world.run(1);
  ASSERT_EQ(world.held(world.robot, kLeftHand).held, box);
  world.run(10 * kSecond);
  const double upper = ArmsWorld::joint(0).upper;
  EXPECT_NEAR(world.state(0).angle, upper, 0.01 * upper);
  world.hands(world.robot).left = false;
  world.run(5 * kSecond);
  EXPECT_NEAR(world.state(0).angle, 0.0, 1e-3);
}

TEST(ArmLimitsTest, AWristDoesNotTurnThroughItsStops) {
  for (const double side : {-1.0, 1.0}) {
    Overloaded world;
    world.commanded(2) = side * 3.14;
    world.run(4 * kSecond);
    // a bar to one side, whose weight turns the wrist further
    const Row bar = world.addBlock({0.02, 1.4, 0.02}, 1.2, flatPose(2.216, 2.11 - side * 0.65, 0.0, 0.55));
    world.hands(world.robot).left = true;
    world.run(1);
    ASSERT_EQ(world.held(world.robot, kLeftHand).held, bar);
    world.run(10 * kSecond);
    EXPECT_NEAR(world.state(2).angle, side * 3.14, 0.01 * 3.14) << "bar to side " << side;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
