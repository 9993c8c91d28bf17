// The noise parameters of devices are aliases of errors of the framework. Results equal the former formulas of the
// devices, computed here from the same random stream, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::test {
namespace {

constexpr std::uint64_t kSeed = 11;
constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

/// The random stream of a device of the first entity in a tick.
RandomStream streamOf(const char* type, std::uint64_t tick) {
  RandomStream random(kSeed, "e1", type);
  random.startTick(tick);
  return random;
}

Row addHandbot(DeviceWorld& world) { return world.add(robotModel("handbot"), {1.0, 1.0, 0.0}); }

TEST(ErrorAliasTest, WheelsHaveTheBitsOfTheirNoise) {
  DeviceWorld world(kSeed);
  ActuatorUnderTest<FootbotWheels> wheels(world, world.addFootbot(1.0, 1.0), {{"noise", "0.07"}});
  const double most = 10.344827586206895;
  for (; world.space.tick < 500; ++world.space.tick) {
    wheels.command.setAngularVelocity(3.7, -10.1);
    RandomStream random = streamOf(FootbotWheels::kType, world.space.tick);
    const double left = 3.7 * random.gaussian(1.0, 0.07);
    const double right = -10.1 * random.gaussian(1.0, 0.07);
    const FootbotWheels& actuation = wheels.actuate();
    ASSERT_EQ(actuation.left, std::clamp(left, -most, most));
    ASSERT_EQ(actuation.right, std::clamp(right, -most, most));
  }
}

TEST(ErrorAliasTest, TheLaserHasTheBitsOfItsNoise) {
  DeviceWorld world(kSeed);
  ActuatorUnderTest<EyebotLaser> laser(world, world.addEyebot(1.0, 1.0, 2.0), {{"noise", "3"}});
  for (; world.space.tick < 500; ++world.space.tick) {
    laser.command.tilt = 0.7;
    const double tilt = 0.7 + streamOf(EyebotLaser::kType, world.space.tick).gaussian(0.0, 3.0 * kRadPerDeg);
    ASSERT_EQ(laser.actuate().tilt, std::clamp(tilt, -0.8, 0.8));
  }
}

TEST(ErrorAliasTest, VelocityHasTheBitsOfItsNoise) {
  DeviceWorld world(kSeed);
  ActuatorUnderTest<EyebotVelocity> velocity(world, world.addEyebot(1.0, 1.0, 2.0),
                                             {{"noise", "0.05"}, {"max_speed", "5"}});
  velocity.command.linear = {0.1, -0.2, 0.3};
  for (; world.space.tick < 500; ++world.space.tick) {
    RandomStream random = streamOf(EyebotVelocity::kType, world.space.tick);
    const EyebotVelocity& actuation = velocity.actuate();
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(actuation.linear[axis], velocity.command.linear[axis] + random.gaussian(0.0, 0.05));
    }
  }
  velocity.stop();
  EXPECT_EQ(world.space.actuation.find<EyebotVelocity>(Row{0})->linear.norm(), 0.0)
      << "a safe stop has no noise, as ever";
}

TEST(ErrorAliasTest, TheRopeHasTheBitsOfItsNoise) {
  DeviceWorld world(kSeed);
  ActuatorUnderTest<HandbotRope> rope(world, addHandbot(world), {{"noise", "0.2"}, {"max_speed", "2"}});
  rope.command.winding_speed = 0.1;
  for (; world.space.tick < 500; ++world.space.tick) {
    ASSERT_EQ(rope.actuate().winding_speed, 0.1 * streamOf(HandbotRope::kType, world.space.tick).gaussian(1.0, 0.2));
  }
}

TEST(ErrorAliasTest, ArmsHaveTheBitsOfTheirNoise) {
  DeviceWorld world(kSeed);
  const Row robot = addHandbot(world);
  ActuatorUnderTest<HandbotArms> arms(world, robot, {{"noise", "4"}});
  arms.command.left = {-0.5, 0.3, 1.0};
  arms.command.right = {0.69, -1.19, -3.1};  // near their stops
  const EntityModel& model = *robotModel("handbot");
  for (; world.space.tick < 500; ++world.space.tick) {
    RandomStream random = streamOf(HandbotArms::kType, world.space.tick);
    const HandbotArms& actuation = arms.actuate();
    const std::array<std::pair<double, double>, 6> angles{{{arms.command.left.shoulder, actuation.left.shoulder},
                                                           {arms.command.left.elbow, actuation.left.elbow},
                                                           {arms.command.left.wrist, actuation.left.wrist},
                                                           {arms.command.right.shoulder, actuation.right.shoulder},
                                                           {arms.command.right.elbow, actuation.right.elbow},
                                                           {arms.command.right.wrist, actuation.right.wrist}}};
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const auto& joint = model.joints[static_cast<std::size_t>(model.findJoint(HandbotArmsState::kNames[i]))];
      const double expected = angles[i].first + random.gaussian(0.0, 4.0 * kRadPerDeg);
      ASSERT_EQ(angles[i].second, std::clamp(expected, joint.lower, joint.upper));
    }
  }
}

TEST(ErrorAliasTest, ArmsAreReadWithTheBitsOfTheirNoise) {
  DeviceWorld world(kSeed);
  const Row robot = addHandbot(world);
  const EntityModel& model = *robotModel("handbot");
  SensorUnderTest<HandbotArmsState> arms(world, robot, {{"noise", "4"}});
  for (; world.space.tick < 200; ++world.space.tick) {
    RandomStream random = streamOf(HandbotArmsState::kType, world.space.tick);
    for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
      world.space.joints[robot][model.findJoint(HandbotArmsState::kNames[i])].angle = 0.1 * static_cast<double>(i);
    }
    const HandbotArmsState& state = arms.sense();
    for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
      ASSERT_EQ(state.joints[i].angle, 0.1 * static_cast<double>(i) + random.gaussian(0.0, 4.0 * kRadPerDeg));
    }
  }
}

TEST(ErrorAliasTest, TheTurretIsReadWithTheBitsOfItsNoise) {
  for (const double angle : {0.5, 3.1}) {
    DeviceWorld world(kSeed);
    const Row robot = world.addFootbot(1.0, 1.0);
    JointState& joint = world.space.joints[robot][robotModel("footbot")->findJoint("turret")];
    joint.angle = angle;
    joint.effort = 0.25;
    SensorUnderTest<FootbotTurretState> turret(world, robot, {{"noise", "5"}, {"noise_torque", "0.01"}});
    for (; world.space.tick < 500; ++world.space.tick) {
      RandomStream random = streamOf(FootbotTurretState::kType, world.space.tick);
      const FootbotTurretState& state = turret.sense();
      ASSERT_EQ(state.angle, wrapAngle(angle + random.gaussian(0.0, 5.0 * kRadPerDeg)));
      ASSERT_EQ(state.torque, 0.25 + random.gaussian(0.0, 0.01));
    }
  }
}

TEST(ErrorAliasTest, ProximityHasTheBitsOfItsNoise) {
  const auto addRobotAtWall = [](DeviceWorld& world) {
    const Row robot = world.addFootbot(1.0, 1.0);
    world.addWall({0.1, 2.0, 0.5}, {1.0 + 0.085 + 0.05 + 0.05, 1.0});
    return robot;
  };
  DeviceWorld world(kSeed);
  DeviceWorld ideal(kSeed);
  const Row robot = addRobotAtWall(world);
  SensorUnderTest<FootbotProximity> ring(world, robot, {{"noise", "0.3"}});
  SensorUnderTest<FootbotProximity> clean(ideal, addRobotAtWall(ideal));
  for (; world.space.tick < 300; ++world.space.tick) {
    if (world.space.tick == 150) {
      world.pose(robot).position.x() = ideal.pose(Row{0}).position.x() = 5.0;  // away from the wall
    }
    RandomStream random = streamOf(FootbotProximity::kType, world.space.tick);
    const FootbotProximity& readings = ring.sense();
    const FootbotProximity& exact = clean.sense();
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      ASSERT_EQ(readings.value[i],
                static_cast<float>(std::clamp(exact.value[i] + random.uniform(-0.3, 0.3), 0.0, 1.0)));
    }
  }
}

}  // namespace
}  // namespace swarmanoid::test
