// The interface of a robot for its controller: exactly the listed devices, a log of limited rate, its own random
// stream.
#include "swarmanoid_interface/robot.hpp"

#include <gtest/gtest.h>

#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

template <class Call>
std::string messageOf(Call call) {
  try {
    call();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}

TEST(RobotTest, GivesTheDevicesThatItWasProvidedWith) {
  Robot robot("fb_1", "footbot", 1);
  FootbotProximity readings;
  FootbotWheels wheels;
  robot.provideSensor(FootbotProximity::kType, &readings);
  robot.provideActuator(FootbotWheels::kType, &wheels);
  EXPECT_EQ(&robot.sensor<FootbotProximity>(), &readings);
  EXPECT_EQ(&robot.actuator<FootbotWheels>(), &wheels);
  EXPECT_TRUE(robot.hasSensor("footbot_proximity"));
  EXPECT_FALSE(robot.hasSensor("footbot_wheels"));
  EXPECT_TRUE(robot.hasActuator("footbot_wheels"));
  EXPECT_FALSE(robot.hasActuator("footbot_proximity"));
}

TEST(RobotTest, SaysWhichDeviceIsMissingAndWhatIsListed) {
  Robot robot("fb_1", "footbot", 1);
  EXPECT_EQ(messageOf([&] { robot.sensor<FootbotProximity>(); }),
            "robot 'fb_1' (footbot) has no sensor 'footbot_proximity' in its controller's configuration; listed: none");
  FootbotWheels wheels;
  robot.provideActuator("footbot_leds", &wheels);
  robot.provideActuator("footbot_gripper", &wheels);
  EXPECT_EQ(messageOf([&] { robot.actuator<FootbotWheels>(); }),
            "robot 'fb_1' (footbot) has no actuator 'footbot_wheels' in its controller's configuration; listed: "
            "footbot_leds, footbot_gripper");
}

TEST(RobotTest, ChanceBelongsToSeedNameAndTick) {
  Robot robot("fb_1", "footbot", 3);
  RandomStream same(3, "fb_1", "controller");
  for (const std::uint64_t tick : {0, 1, 7}) {
    robot.startTick(tick, kEpoch + seconds(tick));
    same.startTick(tick);
    EXPECT_EQ(robot.random().bits(), same.bits());
  }
}

class LogTest : public testing::Test {
 protected:
  LogTest() {
    robot_.setLogSink([this](LogLevel, const std::string& name, const std::string& text) {
      EXPECT_EQ(name, "fb_1");
      texts_.push_back(text);
    });
  }

  /// Logs `count` texts at a time.
  void logAt(Time time, int count) {
    robot_.startTick(0, time);
    for (int i = 0; i < count; ++i) {
      robot_.log("text " + std::to_string(i));
    }
  }

  Robot robot_{"fb_1", "footbot", 1};
  std::vector<std::string> texts_;
};

TEST_F(LogTest, LineBreaksAtTheEndAreLeftOutForTheSinkEndsTheLine) {
  for (const char* text : {"one\n", "two\r\n\n", "three\nlines\nhere", "\n"}) {
    robot_.log(text);
  }
  EXPECT_EQ(texts_, (std::vector<std::string>{"one", "two", "three\nlines\nhere", ""}));
}

TEST_F(LogTest, TenTextsASecondAndThenOneThatSaysSo) {
  logAt(kEpoch, 4);
  logAt(kEpoch + milliseconds(500), 100);
  ASSERT_EQ(texts_.size(), 11U);
  EXPECT_EQ(texts_[9], "text 5");
  EXPECT_EQ(texts_[10], "(more in this second is left out)");
  texts_.clear();
  logAt(kEpoch + milliseconds(999), 1);
  EXPECT_TRUE(texts_.empty());
  logAt(kEpoch + milliseconds(1000), 1);
  EXPECT_EQ(texts_, std::vector<std::string>{"text 0"});
}

TEST_F(LogTest, GoesOnAfterTimeWasPutBack) {
  logAt(kEpoch + seconds(1000), 100);
  texts_.clear();
  logAt(kEpoch, 1);
  EXPECT_EQ(texts_, std::vector<std::string>{"text 0"});
}

TEST_F(LogTest, ALongTextIsCutBetweenLettersAndSaysSo) {
  robot_.log(std::string(9999, 'a') + "\u00e9 and more\n");
  robot_.log(std::string(10000, 'a') + "\n");
  EXPECT_EQ(texts_,
            (std::vector<std::string>{std::string(9999, 'a') + " (found 10010 bytes; beyond 10000 they are left out)",
                                      std::string(10000, 'a')}));
}

TEST_F(LogTest, DebugKeysBeyondTheMostAreLeftOutAndTheFirstIsReported) {
  for (int i = 0; i < 1'000'000; ++i) {  // without the limit, quadratic in the number of keys
    robot_.debug("key " + std::to_string(i), std::to_string(i));
  }
  robot_.debug("key 7", "again");
  ASSERT_EQ(robot_.debugValues().size(), Robot::kMostDebugKeys);
  EXPECT_EQ(robot_.debugValues().front(), Robot::DebugValue("key 0", "0"));
  EXPECT_EQ(robot_.debugValues()[7], Robot::DebugValue("key 7", "again"));
  EXPECT_EQ(robot_.debugValues().back(), Robot::DebugValue("key 99", "99"));
  EXPECT_EQ(texts_, std::vector<std::string>{
                        "found debug key 'key 100' beyond the first 100: it and further ones are left out"});
}

TEST_F(LogTest, LongDebugValuesAreCutBetweenLettersAndTheFirstIsReported) {
  robot_.debug("trace", std::string(Robot::kLongestDebugText, 'a'));
  EXPECT_TRUE(texts_.empty());
  for (int i = 0; i < 2; ++i) {
    robot_.debug("trace", std::string(Robot::kLongestDebugText - 1, 'b') + "\u00e9");
  }
  ASSERT_EQ(robot_.debugValues().size(), 1U);
  EXPECT_EQ(robot_.debugValues()[0].second, std::string(Robot::kLongestDebugText - 1, 'b'));
  EXPECT_EQ(texts_,
            std::vector<std::string>{"found a debug key or value of 1001 bytes: those beyond 1000 are left out"});
}

TEST(RobotTest, KeepsTheLastDebugValueOfEachKeyInOrderOfAppearance) {
  Robot robot("fb_1", "footbot", 1);
  robot.debug("state", "Search for Laser");
  robot.debug("prey", "yellow");
  robot.debug("state", "Go to Nest");
  const std::vector<Robot::DebugValue> expected{{"state", "Go to Nest"}, {"prey", "yellow"}};
  EXPECT_EQ(robot.debugValues(), expected);
}

}  // namespace
}  // namespace swarmanoid
