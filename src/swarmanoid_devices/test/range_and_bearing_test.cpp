// Range and bearing: the messages that are received, and the measured positions of senders. The transmitter of a
// footbot is on its axis, 0.13 m above the ground; that of an eyebot is 0.22 m above its origin.
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "message_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/random.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTransmitterHeight = 0.13;  // m, of footbots' transmitters

/// The only message that was received.
RangeAndBearingMessage only(const Board& board) {
  EXPECT_EQ(board.messages().size(), 1U);
  return board.messages().empty() ? RangeAndBearingMessage{} : board.messages()[0];
}

void expectPlace(const RangeAndBearingMessage& found, double range, double bearing, double elevation) {
  EXPECT_NEAR(found.range, range, 1e-6);
  EXPECT_NEAR(found.bearing, bearing, 1e-6);
  EXPECT_NEAR(found.elevation, elevation, 1e-6);
}

TEST(RangeAndBearingTest, TwoRobotsMeasureEachOther) {
  MessageWorld world;
  const Board a = world.footbot(3.1, 4.2, 0.7);
  const Board b = world.footbot(4.5, 3.3, -2.2);
  a.command->send({1, 2, 3});
  b.command->send({255, 0, 254, 0, 0, 0, 0, 0, 0, 77});
  world.exchange();
  // 1.4 m and -0.9 m away: the direction of B is -0.571337, that of A 2.570255
  expectPlace(only(a), 1.664332, -1.271337, 0.0);
  expectPlace(only(b), 1.664332, -1.512930, 0.0);
  EXPECT_EQ(only(a).payload, b.command->payload);
  EXPECT_EQ(only(b).payload, a.command->payload);
  EXPECT_FALSE(a.received->overflowed);
}

TEST(RangeAndBearingTest, AnEyebotAndAFootbotBelowItMeasureElevations) {
  MessageWorld world;
  const Board footbot = world.footbot(5.0, 5.0, 1.1);
  const Board eyebot = world.eyebot(5.3, 5.4, 1.41, 0.4);
  footbot.command->send({1});
  eyebot.command->send({2});
  world.exchange();
  // 0.5 m away, and 1.41 + 0.22 - 0.13 = 1.5 m above: the tangent of the elevation is 3
  expectPlace(only(footbot), 1.5811388, -0.1727048, 1.2490458);
  expectPlace(only(eyebot), 1.5811388, -2.6142974, -1.2490458);
}

/// Positions of the transmitters, computed by hand: handbot (4.996176, 4.996779, 0.205), footbot (5.9, 4.6, 0.13),
/// eyebot (4.4, 5.8, 1.32).
TEST(RangeAndBearingTest, RobotsOfAllTypesHearEachOther) {
  MessageWorld world;
  const Board handbot = world.equip(world.add(robotModel("handbot"), {5.0, 5.0, 0.0}, 0.7));
  const Board footbot = world.footbot(5.9, 4.6, -1.3);
  const Board eyebot = world.eyebot(4.4, 5.8, 1.1, 2.9);
  for (const Board& board : {handbot, footbot, eyebot}) {
    board.command->send({1});
  }
  world.exchange();
  for (const Board& board : {handbot, footbot, eyebot}) {
    ASSERT_EQ(board.messages().size(), 2U);
  }
  expectPlace(handbot.messages()[0], 0.9899276, -1.1136688, -0.0758358);
  expectPlace(handbot.messages()[1], 1.4979368, 1.5093069, 0.8395717);
  expectPlace(footbot.messages()[0], 0.9899276, -2.2552615, 0.0758358);
  expectPlace(footbot.messages()[1], 2.2596681, -2.5163336, 0.5546267);
  expectPlace(eyebot.messages()[0], 1.4979368, 2.4508995, -0.8395717);
  expectPlace(eyebot.messages()[1], 2.2596681, 2.7084444, -0.5546267);
}

TEST(RangeAndBearingTest, DirectionsAreThoseOfTheRobotsFrameHoweverItLies) {
  MessageWorld world;
  const Board lying = world.eyebot(5.22, 5.0, 1.0);
  world.pose(lying.row).orientation = Eigen::AngleAxisd(-M_PI / 2.0, Eigen::Vector3d::UnitY());  // x axis upwards
  const Board above = world.eyebot(5.0, 5.0, 1.98);
  above.command->send({1});
  world.exchange();
  // its transmitter is at 5.22 - 0.22 = 5 m, and 1.98 + 0.22 - 1 = 1.2 m below the other one
  expectPlace(only(lying), 1.2, 0.0, 0.0);
}

TEST(RangeAndBearingTest, StraightBehindIsPi) {
  MessageWorld world;
  const Board robot = world.footbot(5.0, 5.0);
  const Board behind = world.footbot(4.0, 5.0);
  behind.command->send({1});
  world.exchange();
  EXPECT_EQ(only(robot).bearing, static_cast<float>(M_PI));
}

TEST(RangeAndBearingTest, BearingsAreCounterClockwiseFromAhead) {
  MessageWorld world;
  const Board robot = world.footbot(5.0, 5.0, M_PI / 2.0);  // faces north
  const Board east = world.footbot(6.0, 5.0);
  east.command->send({1});
  world.exchange();
  EXPECT_NEAR(only(robot).bearing, -M_PI / 2.0, 1e-6) << "on its right";
}

TEST(RangeAndBearingTest, WhoIsInRangeIsHeardAndWhoIsBeyondIsNot) {
  for (const double range : {3.0, 1.3}) {
    MessageWorld world(range == 3.0 ? Parameters{} : Parameters{{"range", "1.3"}});
    const Board robot = world.footbot(5.0, 5.0, 2.5);
    const double x = 5.0 + (range - 1e-6) * std::cos(0.9);
    const double y = 5.0 + (range - 1e-6) * std::sin(0.9);
    const Board other = world.footbot(x, y, -0.3);
    other.command->send({1});
    world.exchange();
    EXPECT_NEAR(only(robot).range, range, 2e-6);
    world.pose(other.row).position.x() += 4e-6 * std::cos(0.9);
    world.pose(other.row).position.y() += 4e-6 * std::sin(0.9);
    world.exchange();
    EXPECT_TRUE(robot.messages().empty()) << range;
  }
}

TEST(RangeAndBearingTest, TheRangeCountsBetweenTransmittersInSpace) {
  MessageWorld world(Parameters{{"range", "1.5"}});
  const Board footbot = world.footbot(5.0, 5.0);
  const Board eyebot = world.eyebot(5.9, 5.0, 1.2 + kTransmitterHeight - 0.22 - 1e-6);  // 0.9 m and 1.2 m away
  eyebot.command->send({1});
  world.exchange();
  expectPlace(only(footbot), 1.5, 0.0, std::atan2(1.2, 0.9));
  world.pose(eyebot.row).position.z() += 4e-6;
  world.exchange();
  EXPECT_TRUE(footbot.messages().empty());
}

TEST(RangeAndBearingTest, AWallHidesUnlessTheLineRunsAboveIt) {
  for (const bool needs_sight : {true, false}) {
    MessageWorld world(Parameters{{"line_of_sight", needs_sight ? "true" : "false"}});
    const Board robot = world.footbot(5.0, 5.0, 0.4);
    const Board other = world.footbot(6.8, 5.3, -2.0);
    other.command->send({1});
    const Row wall = world.addWall({0.05, 3.0, 0.14}, {5.9, 5.0});
    world.exchange();
    EXPECT_EQ(robot.messages().size(), needs_sight ? 0U : 1U);
    world.pose(wall).position.z() -= 0.02;  // up to 0.12 m
    world.exchange();
    EXPECT_EQ(robot.messages().size(), 1U);
  }
}

TEST(RangeAndBearingTest, AThirdRobotHidesWhomItStandsBefore) {
  MessageWorld world;
  const Board robot = world.footbot(5.0, 5.0);
  const Board other = world.footbot(7.0, 5.0, 1.0);
  const Row between = world.addFootbot(6.2, 5.08, 0.3);  // 0.085 m in radius at the height of the line
  other.command->send({1});
  robot.command->send({2});
  world.exchange();
  EXPECT_TRUE(robot.messages().empty());
  EXPECT_TRUE(other.messages().empty());
  world.pose(between).position.y() = 5.09;
  world.exchange();
  EXPECT_EQ(robot.messages().size(), 1U);
  EXPECT_EQ(other.messages().size(), 1U);
  world.pose(between).position = {7.2, 5.0, 0.0};  // behind the other robot
  world.exchange();
  EXPECT_EQ(robot.messages().size(), 1U);
  world.pose(between).position = {4.85, 5.0, 0.0};  // behind the robot
  world.exchange();
  EXPECT_EQ(robot.messages().size(), 1U);
}

/// In a crowd with walls, preys and flying robots at random poses, those senders are received that Space::isOccluded
/// does not find hidden.
TEST(RangeAndBearingTest, ACrowdHearsWhomNothingHides) {
  MessageWorld world;
  RandomStream random(5, "crowd", "places");
  std::vector<Board> boards;
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(1.0, 9.0);
    const double y = random.uniform(1.0, 9.0);
    const double heading = random.uniform(-M_PI, M_PI);
    boards.push_back(i % 5 == 0 ? world.eyebot(x, y, random.uniform(0.0, 1.5), heading) : world.footbot(x, y, heading));
    boards.back().command->send({static_cast<std::uint8_t>(i)});
    world.addPrey(random.uniform(1.0, 9.0), random.uniform(1.0, 9.0), colors::kYellow, 0.06, 0.2);
  }
  world.addWall({3.0, 0.05, 0.5}, {4.0, 5.2});
  world.addWall({0.05, 2.0, 0.135}, {7.0, 3.0});
  world.pose(world.addWall({1.0, 0.03, 0.5}, {2.5, 7.5})).orientation =
      Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ());
  world.exchange();
  const auto placeOf = [&](const Board& board) {
    const bool flies = world.space.entities.model[board.row]->type == "eyebot";
    return Eigen::Vector3d(world.pose(board.row).position +
                           Eigen::Vector3d(0.0, 0.0, flies ? 0.22 : kTransmitterHeight));
  };
  int heard = 0;
  int hidden = 0;
  for (const Board& board : boards) {
    std::vector<int> expected;
    std::vector<int> found;
    for (std::size_t i = 0; i < boards.size(); ++i) {
      const Segment line{placeOf(board), placeOf(boards[i])};
      if (&boards[i] == &board || (line.to - line.from).norm() > 3.0) {
        continue;
      }
      const bool is_hidden = world.space.isOccluded(line, board.row, boards[i].row);
      hidden += is_hidden ? 1 : 0;
      if (!is_hidden) {
        expected.push_back(static_cast<int>(i));
      }
    }
    for (const RangeAndBearingMessage& message : board.messages()) {
      found.push_back(message.payload[0]);
    }
    EXPECT_EQ(found, expected) << "in the order of entity numbers";
    heard += static_cast<int>(found.size());
  }
  EXPECT_GT(heard, 300);
  EXPECT_GT(hidden, 200);
}

TEST(RangeAndBearingTest, ARobotWithoutTheLinkHasItsTransmitterInTheMiddleOfItsHeight) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));  // from 0 to 0.146 m
  model->mounts.erase("range_and_bearing");
  MessageWorld world;
  const Board plain = world.equip(world.add(model, {5.0, 5.0, 0.3}));
  const Board other = world.footbot(6.0, 5.0);
  plain.command->send({1});
  world.exchange();
  EXPECT_NEAR(only(other).elevation, std::atan(0.3 + 0.073 - kTransmitterHeight), 1e-6);
}

TEST(RangeAndBearingTest, ATransmitterOnAJointTurnsWithIt) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->mounts["range_and_bearing"] = model->mount("gripper_tip");  // 0.11 m ahead, 0.05 m high, on the turret
  MessageWorld world;
  const Board turning = world.equip(world.add(model, {5.0, 5.0, 0.0}, 0.3));
  const Board other = world.footbot(5.0, 6.5);
  turning.command->send({1});
  world.space.joints[turning.row][0].angle = M_PI / 2.0 - 0.3;  // straight towards the other robot
  world.exchange();
  expectPlace(only(other), std::hypot(1.5 - 0.11, 0.08), -M_PI / 2.0, -std::atan2(0.08, 1.39));
}

TEST(RangeAndBearingTest, ATransmitterFarFromTheBodyIsRefused) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->mounts["range_and_bearing"].position = {0.0, 0.0, 0.146 + 0.09};
  MessageWorld world;
  const Board robot = world.footbot(5.0, 5.0);
  const Board tall = world.equip(world.add(model, {5.5, 5.0, 0.0}));
  tall.command->send({1});
  world.exchange();
  EXPECT_NEAR(only(robot).elevation, std::atan2(0.236 - kTransmitterHeight, 0.5), 1e-6);
  auto taller = std::make_shared<EntityModel>(*model);
  taller->mounts["range_and_bearing"].position.z() = 0.146 + 0.22;
  try {
    world.equip(world.add(taller, {7.0, 5.0, 0.0}));
    FAIL() << "receivers would not find it";
  } catch (const ConfigError& error) {
    const std::string problem = error.what();
    EXPECT_EQ(problem.find("found the device 'range_and_bearing_received' on a footbot whose transmitter (the link "
                           "range_and_bearing, or the middle of its height) is 0.2"),
              0U)
        << problem;
    EXPECT_NE(problem.find(" m outside of its solids, allowed: at most 0.1 m"), std::string::npos) << problem;
  }
}

}  // namespace
}  // namespace swarmanoid::test
