// Recorded controllers in bags: tests the grouping of frames, and refused bags.
#include "../../src/replay/read_bag.hpp"

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>

#include <filesystem>
#include <fstream>

#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::replay {
namespace {

class ReadBagTest : public testing::Test {
 protected:
  void SetUp() override { bag_.open(file_, rosbag::bagmode::Write); }

  void start(double time, const std::string& robot = "fb_1", std::uint64_t run = 0) {
    swarmanoid_msgs::ControllerStart message;
    message.header.stamp = ros::Time(time);
    message.run = run;
    message.robot.name = robot;
    message.robot.location = "recorded.xml:9";
    message.robot.parameters.resize(3);
    message.robot.parameters[0].name = "speed";
    message.robot.parameters[0].value = "0.15";
    message.robot.parameters[1].name = "nest/x";
    message.robot.parameters[1].value = "1";
    message.robot.parameters[2].name = "last";
    bag_.write("/" + robot + "/controller/start", ros::Time(time), message);
  }
  void sensors(double time, std::uint64_t tick, const std::string& robot = "fb_1", std::uint64_t run = 0) {
    swarmanoid_msgs::SensorFrame message;
    message.stamp = ros::Time(time);
    message.run = run;
    message.tick = tick;
    bag_.write("/" + robot + "/controller/sensors", ros::Time(time), message);
  }
  void commands(double time, std::uint64_t tick, std::uint8_t mark, const std::string& robot = "fb_1",
                std::uint64_t run = 0) {
    swarmanoid_msgs::CommandFrame message;
    message.run = run;
    message.tick = tick;
    message.data = {mark};
    bag_.write("/" + robot + "/controller/commands", ros::Time(time), message);
  }

  /// @return the text of the error; "" if the bag is read
  std::string refusal(const std::vector<std::string>& robots = {}) {
    bag_.close();
    try {
      readBag(file_, robots);
    } catch (const ConfigError& error) {
      std::string text = error.what();
      return text.substr(text.find("run.bag"));
    }
    return "";
  }

  const TemporaryFolder owner_{"read_bag_test"};
  const std::filesystem::path& folder_ = owner_.path();
  const std::string file_ = folder_ / "run.bag";
  rosbag::Bag bag_;
};

TEST_F(ReadBagTest, FramesOfATickBelongTogetherInWhateverOrderTheyCame) {
  start(10.0);
  sensors(10.0, 0);
  sensors(10.1, 1);
  commands(10.15, 1, 11);
  commands(10.16, 0, 10);
  sensors(10.2, 2);
  bag_.close();
  const std::vector<RecordedRun> runs = readBag(file_).at("fb_1");
  ASSERT_EQ(1U, runs.size());
  ASSERT_EQ(3U, runs[0].ticks.size());
  EXPECT_EQ(Bytes{10}, runs[0].ticks[0].commands->data);
  EXPECT_EQ(Bytes{11}, runs[0].ticks[1].commands->data);
  EXPECT_FALSE(runs[0].ticks[2].commands);
}

TEST_F(ReadBagTest, ARobotThatIsStartedAgainCountsAnew) {
  for (const double begin : {10.0, 20.0}) {
    start(begin);
    for (std::uint64_t tick = 0; tick < 2; ++tick) {
      sensors(begin + 0.1 * static_cast<double>(tick), tick);
      commands(begin + 0.1 * static_cast<double>(tick) + 0.01, tick, static_cast<std::uint8_t>(begin));
    }
  }
  bag_.close();
  const std::vector<RecordedRun> runs = readBag(file_).at("fb_1");
  ASSERT_EQ(2U, runs.size());
  EXPECT_EQ(2U, runs[0].ticks.size());
  ASSERT_EQ(2U, runs[1].ticks.size());
  EXPECT_EQ(Bytes{10}, runs[0].ticks[1].commands->data);
  EXPECT_EQ(Bytes{20}, runs[1].ticks[1].commands->data);
}

TEST_F(ReadBagTest, ARunAfterAResetHasItsOwnStart) {
  start(1.0);
  sensors(1.0, 0);
  start(1.0, "fb_1", 1);
  sensors(1.0, 0, "fb_1", 1);
  sensors(1.1, 1, "fb_1", 1);
  bag_.close();
  const std::vector<RecordedRun> runs = readBag(file_).at("fb_1");
  ASSERT_EQ(2U, runs.size());
  EXPECT_EQ(1U, runs[0].ticks.size());
  EXPECT_EQ(2U, runs[1].ticks.size());
}

TEST_F(ReadBagTest, ParametersAreReplacedOrComeBeside) {
  start(1.0);
  bag_.close();
  const Configuration parameters = readBag(file_, {}, {{"speed", "0.1", {}}, {"nest/y", "2", {}}, {"new", "x", {}}})
                                       .at("fb_1")[0]
                                       .robot()
                                       .parameters;
  EXPECT_EQ("0.1", parameters.text("speed"));
  EXPECT_EQ("x", parameters.text("new"));
  EXPECT_EQ("1", parameters.find("nest")->text("x"));
  EXPECT_EQ("2", parameters.find("nest")->text("y"));
}

TEST_F(ReadBagTest, ParametersAreFoundWhereTheyWereGiven) {
  start(1.0);
  bag_.close();
  const Configuration parameters = readBag(file_, {},
                                           {{"speed", "1", {"first.yaml", 1}},
                                            {"speed", "fast", {"second.yaml", 7}},
                                            {"nest/y", "2", {"second.yaml", 8}},
                                            {"new", "x", {"--parameters new", 0}}})
                                       .at("fb_1")[0]
                                       .robot()
                                       .parameters;
  EXPECT_EQ("second.yaml:7", parameters.find("speed")->location().toString());
  EXPECT_EQ("recorded.xml:9", parameters.find("nest")->find("x")->location().toString());
  EXPECT_EQ("second.yaml:8", parameters.find("nest")->find("y")->location().toString());
  EXPECT_EQ("--parameters new", parameters.find("new")->location().toString());
  EXPECT_EQ("recorded.xml:9", parameters.find("last")->location().toString());
  EXPECT_EQ("recorded.xml:9", parameters.location().toString());
}

TEST_F(ReadBagTest, OnlyTheRobotsAskedForAreRead) {
  start(1.0);
  start(1.0, "fb_2");
  bag_.close();
  EXPECT_EQ(2U, readBag(file_).size());
  EXPECT_EQ(1U, readBag(file_, {"fb_2"}).count("fb_2"));
  EXPECT_EQ(1U, readBag(file_, {"fb_2"}).size());
}

TEST_F(ReadBagTest, AnUnknownRobotIsRefusedWithThoseThatThereAre) {
  start(1.0);
  start(1.0, "eb");
  EXPECT_EQ("run.bag: found no recorded controller of 'fb_2', there are: eb, fb_1; did you mean 'fb_1'?",
            refusal({"fb_2"}));
}

TEST_F(ReadBagTest, ABagWithoutControllersIsRefused) {
  bag_.write("/clock", ros::Time(1.0), std_msgs::String());
  EXPECT_EQ(
      "run.bag: found no recorded controller, expected topics such as /fb_1/controller/sensors; the simulator writes "
      "them with --record-controllers or record_controllers:=",
      refusal());
}

TEST_F(ReadBagTest, FramesWithoutAStartAreRefused) {
  sensors(1.5, 5);
  EXPECT_EQ("run.bag: 'fb_1': found no /fb_1/controller/start of run 0; record that topic too", refusal());
}

TEST_F(ReadBagTest, AStartThatIsLatchedMayComeAfterTheFirstFrames) {
  sensors(10.0, 40);
  start(10.05);
  sensors(10.1, 41);
  start(20.0);
  sensors(20.0, 0);
  bag_.close();
  const std::vector<RecordedRun> runs = readBag(file_).at("fb_1");
  ASSERT_EQ(2U, runs.size());
  ASSERT_EQ(2U, runs[0].ticks.size());
  EXPECT_EQ(40U, runs[0].ticks[0].sensors.stamp.tick);
  EXPECT_EQ(1U, runs[1].ticks.size());
}

TEST_F(ReadBagTest, AMessageOfAnotherTypeIsRefused) {
  bag_.write("/fb_1/controller/start", ros::Time(1.0), std_msgs::String());
  bag_.close();
  try {
    readBag(file_);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(0U,
              std::string(error.what())
                  .find("/fb_1/controller/start: found std_msgs/String (992ce8a1687cec8c8bd883ec73ca41d1), allowed: "
                        "swarmanoid_msgs/ControllerStart ("));
  }
}

TEST_F(ReadBagTest, WhatIsNoBagIsRefused) {
  bag_.close();
  std::ofstream(file_) << "no bag";
  EXPECT_EQ(0U, refusal().find("run.bag: cannot be read: "));
}

TEST_F(ReadBagTest, ParametersAreWordsOrLinesOfAFile) {
  const std::string file = (folder_ / "parameters.yaml").string();
  std::ofstream(file) << "# other values\nspeed: 0.1\n\nnest/x:  2 # a comment\n";
  const std::vector<ParameterValue> values = readParameters(file);
  ASSERT_EQ(2U, values.size());
  EXPECT_EQ("speed", values[0].name);
  EXPECT_EQ("0.1", values[0].value);
  EXPECT_EQ("nest/x", values[1].name);
  EXPECT_EQ("2", values[1].value);
  EXPECT_EQ(file + ":2", values[0].location.toString());
  EXPECT_EQ(file + ":4", values[1].location.toString());
  EXPECT_EQ("a=b", readParameters("x=a=b")[0].value);
  EXPECT_EQ("--parameters x", readParameters("x=a=b")[0].location.toString());
  std::ofstream(file) << "speed: 0.1\nnest:\n";
  const auto problem = [](const std::string& word) {
    try {
      readParameters(word);
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(file + ":2: found 'nest:', allowed: name: value (of nested ones outer/inner: value)", problem(file));
  EXPECT_EQ("/dev/zero: found a file without an end in sight, allowed: at most 1000000 characters",
            problem("/dev/zero"));
  EXPECT_EQ("/tmp: cannot be read", problem("/tmp"));
  EXPECT_EQ("--parameters: found '/nowhere', allowed: name=value, or a file that can be read", problem("/nowhere"));
}

}  // namespace
}  // namespace swarmanoid::replay
