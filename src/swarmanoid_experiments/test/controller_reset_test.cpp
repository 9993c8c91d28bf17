// A reset forgets everything: in the middle of whatever it does, a controller that is reset goes on like a fresh one.
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::test {
namespace {

constexpr auto kTick = std::chrono::milliseconds(100);

/// A controller whose robot is made of paper: the test says what its sensors read.
class Bench {
 public:
  explicit Bench(const std::string& label) : robot_("robot", "any", 1) {
    robot_.provideSensor(FootbotProximity::kType, &proximity_);
    robot_.provideSensor(FootbotGround::kType, &ground_);
    robot_.provideSensor(FootbotGripperState::kType, &gripper_state_);
    robot_.provideSensor(FootbotCamera::kType, &footbot_camera_);
    robot_.provideSensor(EyebotCamera::kType, &eyebot_camera_);
    robot_.provideSensor(Battery::kType, &battery_);
    robot_.provideActuator(FootbotWheels::kType, &wheels_);
    robot_.provideActuator(FootbotGripper::kType, &gripper_);
    robot_.provideActuator(FootbotLeds::kType, &leds_);
    robot_.provideActuator(EyebotLeds::kType, &eyebot_leds_);
    robot_.provideActuator(EyebotVelocity::kType, &velocity_);
    robot_.provideActuator(EyebotLaser::kType, &laser_);
    loadPluginLibrary(label, {}, {});
    controller_ = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, label));
    Configuration parameters("parameters", "", {});
    if (label == "eyebot_retrieval") {
      parameters.set("prey_color_1", "yellow");
      parameters.set("prey_color_2", "magenta");
    }
    if (label == "sample_footbot_controller") {
      parameters.set("min_distance", "7");
    }
    if (label == "scout") {
      parameters.set("second", "green");
    }
    if (label == "footbot_charging") {
      parameters.set("little", "0.9");
    }
    controller_->init(robot_, parameters);
  }

  /// One step with readings that belong to the story and the tick. What is seen and felt lasts for seconds, so that
  /// every behaviour has the time to be reached.
  void step(std::uint64_t story, std::uint64_t tick) {
    constexpr std::uint64_t kScene = 40;  // ticks
    RandomStream scene(story, "scene", "readings");
    scene.startTick(tick / kScene);
    blobs_.clear();
    const Color palette[] = {colors::kRed,   colors::kYellow, colors::kMagenta,
                             colors::kGreen, colors::kBlue,   colors::kYellow};
    const auto direction = static_cast<float>(scene.uniform(-3.0, 3.0));
    const float distance = scene.uniform() < 0.7 ? 0.3F : 0.03F;
    for (const Color color : palette) {
      if (scene.uniform() < 0.45) {
        const bool is_at_spot = scene.uniform() < 0.7;
        blobs_.push_back({color, is_at_spot ? direction : static_cast<float>(scene.uniform(-3.0, 3.0)),
                          is_at_spot ? distance : static_cast<float>(scene.uniform(0.02, 1.5))});
      }
    }
    footbot_camera_.blobs = blobs_;
    eyebot_camera_.blobs = blobs_;
    gripper_state_.gripping = scene.uniform() < 0.5;
    battery_.capacity = 1.0F;
    battery_.charge = scene.uniform() < 0.2 ? 1.0F : 0.2F;
    proximity_.value.fill(0.0F);
    if (scene.uniform() < 0.4) {
      proximity_.value[scene.below(FootbotProximity::kCount)] = 0.5F;
    }
    ground_.value.fill(scene.uniform() < 0.3 ? 0.667F : 1.0F);
    if (scene.uniform() < 0.5) {
      ground_.value[scene.below(FootbotGround::kCount)] = 0.1F;
    }
    robot_.startTick(tick, kEpoch + tick * kTick);
    controller_->step(kEpoch + tick * kTick, kTick);
  }

  void reset() { controller_->reset(); }

  /// All commands of the robot, as numbers.
  std::vector<double> commands() const {
    std::vector<double> all{wheels_.left,         wheels_.right,         gripper_.closed ? 1.0 : 0.0,
                            velocity_.linear.x(), velocity_.linear.y(),  velocity_.linear.z(),
                            velocity_.yaw_rate,   laser_.on ? 1.0 : 0.0, laser_.pan,
                            laser_.tilt};
    const auto add = [&all](const auto& ring) {
      for (const Color led : ring) {
        all.insert(all.end(),
                   {static_cast<double>(led.red), static_cast<double>(led.green), static_cast<double>(led.blue)});
      }
    };
    add(leds_.ring);
    add(eyebot_leds_.ring);
    return all;
  }

  std::string state() const {
    for (const auto& [key, value] : robot_.debugValues()) {
      if (key == "state") {
        return value;
      }
    }
    return "";
  }

 private:
  Robot robot_;
  std::vector<ColorBlob> blobs_;
  FootbotProximity proximity_;
  FootbotGround ground_;
  FootbotGripperState gripper_state_;
  FootbotCamera footbot_camera_;
  EyebotCamera eyebot_camera_;
  Battery battery_;
  FootbotWheels wheels_;
  FootbotGripper gripper_;
  FootbotLeds leds_;
  EyebotLeds eyebot_leds_;
  EyebotVelocity velocity_;
  EyebotLaser laser_;
  std::shared_ptr<Controller> controller_;
};

class ControllerResetTest : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(ControllerResetTest, GoesOnLikeAFreshOneWheneverItIsReset) {
  const auto& [label, states] = GetParam();
  std::set<std::string> left_from;
  Bench used(label);
  for (std::uint64_t story = 0; story < 150; ++story) {
    const std::uint64_t length = 5 + story * 7 % 400;
    for (std::uint64_t tick = 0; tick < length; ++tick) {
      used.step(story, tick);
    }
    left_from.insert(used.state());
    used.reset();
    Bench fresh(label);
    EXPECT_EQ(used.state(), fresh.state());
    for (std::uint64_t tick = 0; tick < 120; ++tick) {
      used.step(1000 + story, tick);
      fresh.step(1000 + story, tick);
      ASSERT_EQ(used.commands(), fresh.commands()) << "story " << story << ", tick " << tick;
      ASSERT_EQ(used.state(), fresh.state());
    }
    used.reset();
  }
  EXPECT_EQ(left_from.size(), states) << "it was reset in every state";
}

INSTANTIATE_TEST_SUITE_P(Controllers, ControllerResetTest,
                         testing::Values(std::pair("diffusion", 1), std::pair("sample_footbot_controller", 1),
                                         std::pair("footbot_retrieval", 5), std::pair("eyebot_retrieval", 5),
                                         std::pair("footbot_foraging", 4), std::pair("footbot_charging", 3),
                                         std::pair("scout", 2), std::pair("trail_following", 6)),
                         [](const auto& controller) { return std::string(controller.param.first); });

}  // namespace
}  // namespace swarmanoid::test
