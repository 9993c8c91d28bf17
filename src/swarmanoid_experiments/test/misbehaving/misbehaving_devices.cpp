// Misbehaving devices: implementations "misbehaving". phase: configure; in tick 3 sense and report of the sensor,
// actuate and afterMove of the actuator.
#include "actions.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::test {
namespace {

PluginDescription describeDevice(const char* type) {
  PluginDescription description = Misbehaviour::describe(type);
  description.implementation = "misbehaving";
  return description;
}

class MisbehavingSensor final : public SensorOf<FootbotGripperState> {
 public:
  static PluginDescription describe() { return describeDevice(FootbotGripperState::kType); }

  void configure(const Configuration& parameters) override { misbehaviour_.configure(parameters); }
  void sense(const Space& space, std::size_t, std::size_t) override { misbehaviour_.tryIn("sense", space.tick); }
  void report(const Space& space, const ReportAccess&) override { misbehaviour_.tryIn("report", space.tick); }

 private:
  Misbehaviour misbehaviour_;
};

class MisbehavingActuator final : public ActuatorOf<FootbotLeds> {
 public:
  static PluginDescription describe() { return describeDevice(FootbotLeds::kType); }

  void configure(const Configuration& parameters) override { misbehaviour_.configure(parameters); }
  void actuate(const Space& space, const ActuateAccess&, std::vector<Row>&) override {
    misbehaviour_.tryIn("actuate", space.tick);
  }
  void afterMove(const Space& space, const AfterMoveAccess&) override { misbehaviour_.tryIn("afterMove", space.tick); }

 private:
  Misbehaviour misbehaviour_;
};

}  // namespace
}  // namespace swarmanoid::test

REGISTER_SENSOR(swarmanoid::test::MisbehavingSensor)
REGISTER_ACTUATOR(swarmanoid::test::MisbehavingActuator)
