#include "swarmanoid_hosts/controller_host.hpp"

#include <gtest/gtest.h>

#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid {
namespace {

/// The left wheel counts steps, the right one draws a random number, and the gripper's state selects whether it fails.
class Counter final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.sensor<FootbotGripperState>();
    parameters.refuseUnread();
  }
  void step(Time, Duration) override {
    if (gripper_->gripping) {
      throw std::runtime_error("it holds something");
    }
    wheels_->left += 1.0;
    wheels_->right = robot_->random().uniform();
    robot_->debug("state", "counting");
  }

 private:
  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  const FootbotGripperState* gripper_ = nullptr;
};

Registration oneRobot() {
  Registration registration;
  registration.session = 3;
  registration.seed = 7;
  registration.robots.push_back({"fb_1",
                                 "footbot",
                                 "fc",
                                 "counter",
                                 {{"footbot_gripper_state", "b1"}},
                                 {{"footbot_wheels", "f8 f8"}},
                                 Configuration("parameters", "", {})});
  return registration;
}

SensorFrame frameOf(std::uint64_t run, std::uint64_t tick, bool is_present = true, bool gripping = false) {
  SensorFrame frame;
  frame.stamp = {3, run, tick};
  frame.seed = 7;
  ByteWriter out(frame.data);
  out.number(static_cast<std::uint8_t>(is_present));
  if (is_present) {
    const std::size_t begin = out.openBlock();
    out.number(gripping);
    out.closeBlock(begin);
  }
  return frame;
}

struct Answer {
  StepStatus status;
  double left = -1.0;
  double right = -1.0;
  std::string text;
};

Answer read(const CommandFrame& frame) {
  ByteReader in(frame.data);
  Answer answer{static_cast<StepStatus>(in.number<std::uint8_t>()), -1.0, -1.0, ""};
  if (answer.status == StepStatus::kStepped) {
    ByteReader block = in.block();
    block.number(answer.left);
    block.number(answer.right);
    EXPECT_EQ(1U, in.number<std::uint32_t>());
    EXPECT_EQ("state", in.text());
    answer.text = in.text();
  } else if (answer.status == StepStatus::kFailed) {
    answer.text = in.text();
  }
  EXPECT_EQ(0U, in.left());
  return answer;
}

std::string refusalOf(const Registration& registration) {
  try {
    ControllerHost host(
        registration, [] { return std::make_shared<Counter>(); }, nullptr);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(ControllerHostTest, AnswersEachTickWithCommands) {
  ControllerHost host(
      oneRobot(), [] { return std::make_shared<Counter>(); }, nullptr);
  RandomStream random(7, "fb_1", "controller");
  for (std::uint64_t tick = 0; tick < 3; ++tick) {
    const CommandFrame& frame = host.answer(frameOf(0, tick));
    EXPECT_EQ((FrameStamp{3, 0, tick}), frame.stamp);
    const Answer answer = read(frame);
    random.startTick(tick);
    EXPECT_EQ(static_cast<double>(tick + 1), answer.left);
    EXPECT_EQ(random.uniform(), answer.right);
    EXPECT_EQ("counting", answer.text);
  }
}

TEST(ControllerHostTest, TheSameFrameTwiceStepsOnce) {
  ControllerHost host(
      oneRobot(), [] { return std::make_shared<Counter>(); }, nullptr);
  host.answer(frameOf(0, 4));
  EXPECT_EQ(1.0, read(host.answer(frameOf(0, 4))).left);
  EXPECT_EQ(2.0, read(host.answer(frameOf(0, 5))).left);
}

TEST(ControllerHostTest, AnewAfterAResetAndWhenTheRobotComesBack) {
  ControllerHost host(
      oneRobot(), [] { return std::make_shared<Counter>(); }, nullptr);
  host.answer(frameOf(0, 0));
  EXPECT_EQ(2.0, read(host.answer(frameOf(0, 1))).left);
  EXPECT_EQ(1.0, read(host.answer(frameOf(1, 0))).left);
  EXPECT_EQ(StepStatus::kNothing, read(host.answer(frameOf(1, 1, false))).status);
  EXPECT_EQ(1.0, read(host.answer(frameOf(1, 2))).left);
}

TEST(ControllerHostTest, SaysWhyAControllerFailed) {
  ControllerHost host(
      oneRobot(), [] { return std::make_shared<Counter>(); }, nullptr);
  const Answer answer = read(host.answer(frameOf(0, 0, true, true)));
  EXPECT_EQ(StepStatus::kFailed, answer.status);
  EXPECT_EQ("it holds something", answer.text);
}

TEST(ControllerHostTest, RefusesAFrameThatDoesNotFit) {
  ControllerHost host(
      oneRobot(), [] { return std::make_shared<Counter>(); }, nullptr);
  SensorFrame longer = frameOf(0, 0);
  longer.data[1] = 2;
  longer.data.push_back(0);
  try {
    host.answer(longer);
    FAIL();
  } catch (const ByteError& error) {
    EXPECT_STREQ("fb_1, footbot_gripper_state: found 1 bytes more than expected", error.what());
  }
}

TEST(ControllerHostTest, RefusesDevicesThatItDoesNotKnow) {
  Registration registration = oneRobot();
  registration.robots[0].sensors[0].type = "footbot_griper_state";
  EXPECT_NE(
      std::string::npos,
      refusalOf(registration).find("device 'footbot_griper_state' of robot 'fb_1' is not registered in this process"));
  registration = oneRobot();
  registration.robots[0].actuators[0].layout = "f4 f4";
  EXPECT_EQ(
      "device 'footbot_wheels' of robot 'fb_1' has the fields 'f4 f4' in the space, and 'f8 f8' here; build both "
      "from the same version",
      refusalOf(registration));
  Registration swapped = oneRobot();
  swapped.robots[0].actuators[0].names = "right left";
  EXPECT_EQ(
      "device 'footbot_wheels' of robot 'fb_1' has the fields 'right left' in the space, and 'left right' here; build "
      "both from the same version",
      refusalOf(swapped));
  swapped.robots[0].actuators[0].names = "left right";
  EXPECT_EQ("", refusalOf(swapped));
}

TEST(ControllerHostTest, ControllersMayRefuseToStart) {
  Registration registration = oneRobot();
  registration.robots[0].parameters.set("sped", "1");
  EXPECT_NE(std::string::npos, refusalOf(registration).find("sped"));
}

}  // namespace
}  // namespace swarmanoid
