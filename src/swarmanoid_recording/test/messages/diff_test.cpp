// Two bags are compared field by field: exactly the fields that differ are named.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>

#include <cmath>
#include <limits>

#include "../../src/diff/bag_reader.hpp"
#include "../../src/diff/compare.hpp"
#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::diff {
namespace {

using Names = std::vector<std::string>;

class DiffTest : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  static swarmanoid_msgs::NamedState state(std::uint64_t tick, Names names, std::vector<double> numbers, Names texts) {
    swarmanoid_msgs::NamedState message;
    message.tick = tick;
    message.names = std::move(names);
    message.numbers = std::move(numbers);
    message.texts = std::move(texts);
    return message;
  }

  /// Writes a bag with one state a tick, from 0.
  std::string bag(const std::string& name, const std::vector<swarmanoid_msgs::NamedState>& states) const {
    rosbag::Bag bag(file(name), rosbag::bagmode::Write);
    for (const auto& message : states) {
      bag.write("/space/named_state", ros::Time(1.0 + 0.1 * static_cast<double>(message.tick)), message);
    }
    return file(name);
  }

  /// Returns the differences of all ticks, as "field: first | second".
  static Names differences(const std::string& first_file, const std::string& second_file) {
    BagReader first(first_file);
    BagReader second(second_file);
    Names out;
    while (true) {
      const auto a = first.next();
      const auto b = second.next();
      if (!a || !b) {
        EXPECT_EQ(a.has_value(), b.has_value());
        return out;
      }
      for (const Difference& difference : compare({*a, first.robots()}, {*b, second.robots()})) {
        out.push_back(difference.field + ": " + difference.first + " | " + difference.second);
      }
    }
  }

  const TemporaryFolder folder_{"diff_test"};
};

TEST_F(DiffTest, OneBitIsADifferenceAndTheSignOfZeroIsNone) {
  const Names names{"fb_1/pose/position/x", "fb_1/pose/position/y", "fb_1/engine"};
  const double x = 1.0 / 3.0;
  const std::string first = bag("a.bag", {state(0, names, {x, 0.0}, {"ground"}), state(1, {}, {x, 0.0}, {"ground"})});
  const std::string same = bag("b.bag", {state(0, names, {x, -0.0}, {"ground"}), state(1, {}, {x, -0.0}, {"ground"})});
  EXPECT_EQ(Names{}, differences(first, same));
  const std::string other =
      bag("c.bag", {state(0, names, {x, 0.0}, {"ground"}), state(1, {}, {std::nextafter(x, 1.0), 0.0}, {"ceiling"})});
  EXPECT_EQ(
      (Names{"fb_1/pose/position/x: 0.3333333333333333 | 0.33333333333333337", "fb_1/engine: 'ground' | 'ceiling'"}),
      differences(first, other));
}

TEST_F(DiffTest, WhatIsNoNumberEqualsItself) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::string first = bag("a.bag", {state(0, {"x"}, {none}, {})});
  EXPECT_EQ(Names{}, differences(first, bag("b.bag", {state(0, {"x"}, {-none}, {})})));
  EXPECT_EQ(Names{"x: nan | 0"}, differences(first, bag("c.bag", {state(0, {"x"}, {0.0}, {})})));
}

TEST_F(DiffTest, AWorldStateThatLacksValuesIsRefused) {
  swarmanoid_msgs::WorldState world;
  world.tick = 3;
  world.names = {"fb_1", "fb_2"};
  world.poses.resize(2);
  world.twists.resize(2);
  world.colors.resize(2);
  world.gripped.resize(1);
  world.engines.resize(2);
  {
    rosbag::Bag bag(file("short.bag"), rosbag::bagmode::Write);
    bag.write("/space/world_state", ros::Time(1.3), world);
  }
  BagReader reader(file("short.bag"));
  reader.choose(StateSource::kWorldState);
  try {
    reader.next();
    ADD_FAILURE() << "it has one value for two entities";
  } catch (const ConfigError& error) {
    EXPECT_EQ(file("short.bag") + ": found 1 gripped of 2 entities in the world state after tick 3; expected as many",
              std::string(error.what()));
  }
}

TEST_F(DiffTest, FieldsThatOnlyOneHasAreNamed) {
  const std::string first = bag("a.bag", {state(0, {"fb_1/x", "fb_2/x"}, {1.5, 2.5}, {})});
  const std::string second = bag("b.bag", {state(0, {"fb_2/x", "fb_3/x"}, {2.5, 3.5}, {})});
  EXPECT_EQ((Names{"fb_1/x: 1.5 | not recorded", "fb_3/x: not recorded | 3.5"}), differences(first, second));
}

TEST_F(DiffTest, NamesStayUntilTheyChange) {
  const std::string first =
      bag("a.bag", {state(0, {"fb_1/x"}, {1.0}, {}), state(1, {}, {2.0}, {}), state(2, {"fb_2/x"}, {3.0}, {})});
  const std::string second =
      bag("b.bag", {state(0, {"fb_1/x"}, {1.0}, {}), state(1, {}, {2.5}, {}), state(2, {"fb_2/x"}, {3.5}, {})});
  EXPECT_EQ((Names{"fb_1/x: 2 | 2.5", "fb_2/x: 3 | 3.5"}), differences(first, second));
}

TEST_F(DiffTest, ReadingsAndCommandsAreNamedByDeviceAndField) {
  const auto write = [this](const std::string& name, float reading, double command) {
    rosbag::Bag bag(file(name), rosbag::bagmode::Write);
    swarmanoid_msgs::ControllerStart start;
    start.robot.name = "fb_1";
    start.robot.location = "recorded.xml:9";
    start.robot.sensors.resize(1);
    start.robot.sensors[0].type = "eye";
    start.robot.sensors[0].layout = "u1 f4";
    start.robot.actuators.resize(1);
    start.robot.actuators[0].type = "leg";
    start.robot.actuators[0].layout = "f8";
    bag.write("/fb_1/controller/start", ros::Time(1.0), start);
    std::vector<std::uint8_t> readings;
    ByteWriter sensors(readings);
    sensors.number(std::uint8_t{1});
    sensors.number(std::uint32_t{5});
    sensors.number(std::uint8_t{7});
    sensors.number(reading);
    swarmanoid_msgs::SensorFrame sensor_frame;
    sensor_frame.data = readings;
    bag.write("/fb_1/controller/sensors", ros::Time(1.0), sensor_frame);
    std::vector<std::uint8_t> bytes;
    ByteWriter commands(bytes);
    commands.number(static_cast<std::uint8_t>(StepStatus::kStepped));
    commands.number(std::uint32_t{8});
    commands.number(command);
    commands.number(std::uint32_t{0});
    swarmanoid_msgs::CommandFrame command_frame;
    command_frame.data = bytes;
    bag.write("/fb_1/controller/commands", ros::Time(1.0), command_frame);
    bag.write("/space/named_state", ros::Time(1.1), state(1, {"fb_1/x"}, {command}, {}));
    return file(name);
  };
  const std::string first = write("a.bag", 0.25F, -3.5);
  EXPECT_EQ(Names{}, differences(first, write("b.bag", 0.25F, -3.5)));
  EXPECT_EQ((Names{"fb_1/reading eye/1: 0.25 | 0.125", "fb_1/command leg/0: -3.5 | 3.5", "fb_1/x: -3.5 | 3.5"}),
            differences(first, write("c.bag", 0.125F, 3.5)));
}

TEST_F(DiffTest, BagsWithoutAStateAndOtherFilesAreRefused) {
  const auto refusal = [](const std::string& name) {
    try {
      const BagReader reader(name);
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  {
    rosbag::Bag bag(file("empty.bag"), rosbag::bagmode::Write);
    bag.write("/chatter", ros::Time(1.0), std_msgs::String());
  }
  EXPECT_EQ(file("empty.bag") + ": found no state of a space, expected a bag of `swarmanoid run --bag`",
            refusal(file("empty.bag")));
  EXPECT_NE(std::string::npos, refusal(file("none.bag")).find(file("none.bag") + ": cannot be read: "));
}

}  // namespace
}  // namespace swarmanoid::diff
