/// One footbot with a controller, for tests of the controller's reactions to messages and blobs.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid::test {

/// A footbot with wheels, range and bearing, and the camera. The test sets the readings, without a space, and inspects
/// the commands of the controller.
class OneFootbot {
 public:
  /// @param controller the label of an installed controller, whose library has the same name
  OneFootbot(const std::string& controller, const NamedValues& values) {
    robot_.provideSensor(FootbotCamera::kType, &camera_);
    robot_.provideSensor(RangeAndBearingReceived::kType, &received_);
    robot_.provideActuator(FootbotWheels::kType, &wheels);
    robot_.provideActuator(RangeAndBearing::kType, &transmitter);
    loadPluginLibrary(controller, {}, {});
    controller_ = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, controller));
    Configuration parameters("parameters", "", {});
    for (const auto& [name, value] : values) {
      parameters.set(name, value);
    }
    controller_->init(robot_, parameters);
  }
  OneFootbot(const OneFootbot&) = delete;
  OneFootbot& operator=(const OneFootbot&) = delete;

  /// Adds a message that is received in each step. @param range [m] @param bearing [rad]
  void hear(double range, double bearing, const RangeAndBearing::Payload& payload = {}) {
    messages_.push_back({static_cast<float>(range), static_cast<float>(bearing), 0.0F, payload});
    received_.messages = messages_;
  }
  /// Adds a blob that is seen in each step. @param distance [m] @param bearing [rad]
  void see(Color color, double distance, double bearing) {
    blobs_.push_back({color, static_cast<float>(bearing), static_cast<float>(distance)});
    camera_.blobs = blobs_;
  }
  /// Makes one step of the controller, of 100 ms.
  void step() { controller_->step(kEpoch, std::chrono::milliseconds(100)); }

  FootbotWheels wheels;
  RangeAndBearing transmitter;

 private:
  Robot robot_{"robot", "footbot", 1};
  FootbotCamera camera_;
  RangeAndBearingReceived received_;
  std::vector<ColorBlob> blobs_;
  std::vector<RangeAndBearingMessage> messages_;
  std::shared_ptr<Controller> controller_;
};

}  // namespace swarmanoid::test
