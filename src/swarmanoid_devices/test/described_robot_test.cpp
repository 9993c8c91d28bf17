// Joints and holders of a robot that is described by a URDF alone.
#include <gtest/gtest.h>

#include <fstream>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::test {
namespace {

std::string link(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><mass value='0.4'/><inertia ixx='1e-3' ixy='0' ixz='0' iyy='1e-3' iyz='0' izz='1e-3'/></inertial>"
         "</link>";
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& limit) {
  return "<joint name='" + name + "' type='" + (limit.find("lower") == std::string::npos ? "continuous" : "revolute") +
         "'><origin xyz='0.05 0 0.1'/><parent link='" + parent + "'/><child link='" + child +
         "'/><axis xyz='0 1 0'/><limit effort='1.5' " + limit + "/></joint>" + link(child);
}

/// The joints in the URDF have another order than in the model.
std::shared_ptr<const EntityModel> loadCrane() {
  const TemporaryFolder folder("described_robot_test");
  const std::string file = folder.path() / "crane.urdf";
  std::ofstream(file) << "<robot name='crane'><swarmanoid title='Crane' summary='It lifts.'>"
                         "<rope name='winch' link='head' length='1.5'/><magnet name='claw' link='hand'/></swarmanoid>"
                         "<link name='base_link'><collision><geometry><cylinder radius='0.1' length='0.2'/></geometry>"
                         "</collision></link>"
                      << joint("wrist", "forearm", "hand", "velocity='4' lower='-0.3' upper='0.45'")
                      << joint("shoulder", "base_link", "arm", "velocity='1.25' lower='-1.1' upper='0.2'")
                      << joint("neck", "base_link", "head", "velocity='2.5'")
                      << joint("elbow", "arm", "forearm", "velocity='3' lower='-2' upper='0.6'") << "</robot>";
  return loadRobotModel("crane", file);
}

class DescribedRobotTest : public testing::Test {
 protected:
  std::vector<std::string> jointNames() const {
    std::vector<std::string> names;
    for (const EntityModel::Joint& each : crane->joints) {
      names.push_back(each.name);
    }
    return names;
  }

  const std::shared_ptr<const EntityModel> crane = loadCrane();
  DeviceWorld world;
  const Row robot = world.add(crane, {1.0, 1.0, 0.0});
};

/// Parents come before children; joints of one link are ordered by name.
TEST_F(DescribedRobotTest, ItsJointsAreLimitedAsItsDescriptionSays) {
  ASSERT_EQ(jointNames(), (std::vector<std::string>{"neck", "shoulder", "elbow", "wrist"}));
  ActuatorUnderTest<Joints> joints(world, robot);
  for (std::size_t i = 0; i < 4; ++i) {
    joints.command.joints[i].holdAngle(5.5);
  }
  joints.actuate();
  const Span<const JointCommand> commands = world.space.joint_commands[robot];
  ASSERT_EQ(commands.size(), 4U);
  EXPECT_EQ(commands[0].value, 5.5) << "it has no stops";
  EXPECT_EQ(commands[1].value, 0.2);
  EXPECT_EQ(commands[2].value, 0.6);
  EXPECT_EQ(commands[3].value, 0.45);
  for (std::size_t i = 0; i < 4; ++i) {
    joints.command.joints[i].turnAt(-9.0);
  }
  joints.actuate();
  EXPECT_EQ(commands[0].value, -2.5);
  EXPECT_EQ(commands[1].value, -1.25);
  EXPECT_EQ(commands[2].value, -3.0);
  EXPECT_EQ(commands[3].value, -4.0);
}

TEST_F(DescribedRobotTest, ItsStatesAreInTheSameOrders) {
  SensorUnderTest<JointStates> joints(world, robot);
  SensorUnderTest<HolderStates> holders(world, robot);
  world.space.joints[robot][crane->findJoint("elbow")] = {-1.75, 0.5, 1.25};
  const Row ceiling = world.addWall({1.0, 1.0, 0.1}, {1.0, 1.0});
  world.space.attachments.attach(robot, 0, {ceiling, {0.0, 0.0, 0.0}, 0.875, 12.5});
  ASSERT_EQ(joints.sense().joints.size(), 4U);
  EXPECT_EQ(joints.sense().joints[2].angle, -1.75);
  EXPECT_EQ(joints.sense().joints[2].effort, 1.25);
  EXPECT_EQ(joints.sense().joints[3].angle, 0.0);
  ASSERT_EQ(holders.sense().holders.size(), 2U);
  EXPECT_EQ(holders.sense().holders[0].length, 0.875) << "the winch stands first";
  EXPECT_FALSE(holders.sense().holders[1].is_holding);
}

TEST_F(DescribedRobotTest, ItsWinchWindsAndItsClawHolds) {
  ActuatorUnderTest<Holders> holders(world, robot);
  holders.command.holders[0] = {true, -0.15};
  holders.command.holders[1].holds = true;
  holders.actuate();
  const Span<const HolderCommand> commands = world.space.holder_commands[robot];
  ASSERT_EQ(commands.size(), 2U);
  EXPECT_TRUE(commands[0].holds);
  EXPECT_EQ(commands[0].winding_speed, -0.15);
  EXPECT_TRUE(commands[1].holds);
  EXPECT_EQ(commands[1].winding_speed, 0.0);
}

}  // namespace
}  // namespace swarmanoid::test
