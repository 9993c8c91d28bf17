// A reset clears all state: a controller that is reset at any time continues like a new one.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_beacon.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::test {
namespace {

constexpr auto kTick = std::chrono::milliseconds(100);

/// A controller with a robot whose readings the test sets.
class Bench {
 public:
  explicit Bench(const std::string& label) : robot_("robot", "any", 1) {
    robot_.provideSensor(FootbotProximity::kType, &proximity_);
    robot_.provideSensor(FootbotGround::kType, &ground_);
    robot_.provideSensor(FootbotGripperState::kType, &gripper_state_);
    robot_.provideSensor(FootbotCamera::kType, &footbot_camera_);
    robot_.provideSensor(EyebotCamera::kType, &eyebot_camera_);
    robot_.provideSensor(Battery::kType, &battery_);
    robot_.provideSensor(Light::kType, &light_);
    robot_.provideSensor(RangeAndBearingReceived::kType, &messages_received_);
    robot_.provideSensor(WifiReceived::kType, &wifi_received_);
    robot_.provideSensor(FootbotTurretState::kType, &turret_state_);
    robot_.provideSensor(HandbotArmsState::kType, &arms_state_);
    robot_.provideSensor(HandbotHandsState::kType, &hands_state_);
    robot_.provideSensor(HandbotRopeState::kType, &rope_state_);
    robot_.provideSensor(HandbotDistance::kType, &distance_);
    robot_.provideActuator(FootbotWheels::kType, &wheels_);
    robot_.provideActuator(FootbotGripper::kType, &gripper_);
    robot_.provideActuator(RangeAndBearing::kType, &messages_);
    robot_.provideActuator(FootbotLeds::kType, &leds_);
    robot_.provideActuator(FootbotBeacon::kType, &beacon_);
    robot_.provideActuator(EyebotLeds::kType, &eyebot_leds_);
    robot_.provideActuator(EyebotVelocity::kType, &velocity_);
    robot_.provideActuator(EyebotLaser::kType, &laser_);
    robot_.provideActuator(Wifi::kType, &wifi_);
    robot_.provideActuator(FootbotTurret::kType, &turret_);
    robot_.provideActuator(HandbotArms::kType, &arms_);
    robot_.provideActuator(HandbotHands::kType, &hands_);
    robot_.provideActuator(HandbotRope::kType, &rope_);
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
    if (label == "footbot_battery_foraging") {
      parameters.set("little", "0.22");  // with a charge of 0.2 the robot sometimes recharges, and forages otherwise
    }
    if (label == "chain_formation") {
      parameters.set("distance", "0.3");
      parameters.set("joining", "3");
      parameters.set("leaving", "1");
    }
    controller_->init(robot_, parameters);
  }

  /// One step with readings that depend on the story and the tick. A scene lasts for seconds, so that every behaviour
  /// is reached.
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
    messages_heard_.clear();
    if (scene.uniform() < 0.6) {
      RangeAndBearingMessage& message = messages_heard_.emplace_back();
      message.range = scene.uniform() < 0.3 ? 0.4F : 2.0F;
      message.bearing = direction;
    }
    messages_received_.messages = messages_heard_;
    lights_.assign(24, {scene.uniform() < 0.5 ? 0.5F : 0.0F, 0.0F});
    light_.sensors = lights_;
    for (const Color color : {colors::kCyan, colors::kOrange, colors::kWhite}) {
      if (scene.uniform() < 0.45) {
        blobs_.push_back({color, direction, distance});
      }
    }
    footbot_camera_.blobs = blobs_;
    eyebot_camera_.blobs = blobs_;
    senseHandsAndWords(scene);
    robot_.startTick(tick, kEpoch + tick * kTick);
    controller_->step(kEpoch + tick * kTick, kTick);
  }

  /// The rope has its initial length again.
  void reset() {
    controller_->reset();
    rope_state_.length = kRopeLength;
  }

  /// Returns all commands of the robot, as numbers.
  std::vector<double> commands() const {
    std::vector<double> all{wheels_.left,         wheels_.right,          gripper_.closed ? 1.0 : 0.0,
                            velocity_.linear.x(), velocity_.linear.y(),   velocity_.linear.z(),
                            velocity_.yaw_rate,   laser_.on ? 1.0 : 0.0,  laser_.pan,
                            laser_.tilt,          arms_.left.shoulder,    arms_.right.shoulder,
                            arms_.left.elbow,     arms_.right.elbow,      hands_.left ? 1.0 : 0.0,
                            rope_.winding_speed,  rope_.shot ? 1.0 : 0.0, turret_.angle};
    const auto addMessage = [&all](const auto& message) {
      all.push_back(message.sends ? 1.0 : 0.0);
      all.insert(all.end(), message.payload.begin(), message.payload.end());
    };
    addMessage(messages_);
    addMessage(wifi_);
    const auto add = [&all](const auto& ring) {
      for (const Color led : ring) {
        all.insert(all.end(),
                   {static_cast<double>(led.red), static_cast<double>(led.green), static_cast<double>(led.blue)});
      }
    };
    add(leds_.ring);
    add(std::array{beacon_.color});
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
  static constexpr double kRopeLength = 1.0;  // m

  /// The joints of arms and turret are at their commands, and the rope has the length that it was wound to.
  void senseHandsAndWords(RandomStream& scene) {
    wifi_heard_.clear();
    if (scene.uniform() < 0.8) {
      wifi_heard_.emplace_back().payload[0] = static_cast<std::uint8_t>(scene.below(4));
    }
    wifi_received_.messages = wifi_heard_;
    turret_state_.angle = turret_.angle;
    arms_state_.joints[0].angle = arms_.left.shoulder;
    const bool is_object_there = scene.uniform() < 0.5;
    hands_state_.left.holding = hands_.left && is_object_there;
    const bool is_ceiling_there = scene.uniform() < 0.5;
    rope_state_.attached = rope_.shot && is_ceiling_there;
    rope_state_.length -= 0.1 * rope_.winding_speed;
    rope_state_.tension = scene.uniform() < 0.3 ? 0.1 : 5.0;
    distance_.value(0) = scene.uniform() < 0.6 ? 0.07F : 0.29F;
  }

  Robot robot_;
  std::vector<ColorBlob> blobs_;
  FootbotProximity proximity_;
  FootbotGround ground_;
  FootbotGripperState gripper_state_;
  FootbotCamera footbot_camera_;
  EyebotCamera eyebot_camera_;
  Battery battery_;
  std::vector<LightReading> lights_;
  Light light_;
  std::vector<RangeAndBearingMessage> messages_heard_;
  RangeAndBearingReceived messages_received_;
  std::vector<WifiMessage> wifi_heard_;
  WifiReceived wifi_received_;
  FootbotTurretState turret_state_;
  HandbotArmsState arms_state_;
  HandbotHandsState hands_state_;
  HandbotRopeState rope_state_{false, kRopeLength, 0.0};
  HandbotDistance distance_;
  FootbotWheels wheels_;
  FootbotGripper gripper_;
  RangeAndBearing messages_;
  FootbotLeds leds_;
  FootbotBeacon beacon_;
  EyebotLeds eyebot_leds_;
  EyebotVelocity velocity_;
  EyebotLaser laser_;
  Wifi wifi_;
  FootbotTurret turret_;
  HandbotArms arms_;
  HandbotHands hands_;
  HandbotRope rope_;
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
                                         std::pair("scout", 2), std::pair("trail_following", 6),
                                         std::pair("aggregation", 2), std::pair("emergent_taxis", 3),
                                         std::pair("chain_formation", 5), std::pair("footbot_battery_foraging", 6),
                                         std::pair("flocking", 1), std::pair("predators", 1), std::pair("carrying", 5),
                                         std::pair("climbing", 8)),
                         [](const auto& controller) { return std::string(controller.param.first); });

}  // namespace
}  // namespace swarmanoid::test
