/// Base class of sensors that measure the turns of two wheels: once a tick, from the engine that moves the robot
/// (Space::wheel_turns), in whole steps of an encoder.
#pragma once

#include <string>

#include "common/mechanisms.hpp"
#include "common/parameters.hpp"
#include "common/tick_guard.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

template <class Device>
struct WheelTurnInstance : BasicSensorInstance<Device> {
  EntityModel::Wheels wheels;
  WheelTurns start;    // wheel turns when the sensor was added [rad]
  WheelTurns counted;  // turned since then [rad]
  Device state;        // readings without errors
  TickGuard tick;

  void archive(StateArchive& saved) {
    saved(start, counted, tick);
    archiveDevice(saved, state);
  }
};

/// `Counter` derives from this, and computes its readings from the wheel turns of a tick:
/// `void count(const Space&, Instance&, const WheelTurns& turned, const WheelTurns& step, double dt)` writes
/// `state`. `turned` counts since the sensor was added, `step` is its change in this tick, both in rad.
template <class Counter, class Device>
class WheelTurnSensor : public SensorOf<Device, WheelTurnInstance<Device>> {
 public:
  using Instance = WheelTurnInstance<Device>;

  void configure(const Configuration& parameters) override {
    ticks_per_turn_ = static_cast<double>(parameters.integer("ticks_per_turn", 0));
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    const double dt = toSeconds(space.clocktick);
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, dt, this->instances_[k]);
    }
  }

 protected:
  static PluginDescription describeCounter(const std::string& summary) {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {wheels()};
    description.summary = summary;
    description.parameters = {
        integer("ticks_per_turn", "0", {0.0, 1e6}, "Resolution of the encoders, in steps per turn; 0: exact.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    if (!model.wheels) {
      refuseWithout(Device::kType, model, "wheels");
    }
    instance.wheels = *model.wheels;
    instance.start = space.wheel_turns[instance.row];
  }

 private:
  void senseOne(const Space& space, double dt, Instance& instance) {
    if (instance.tick.begins(space.tick)) {  // otherwise the wheels have not moved
      const WheelTurns& now = space.wheel_turns[instance.row];
      const WheelTurns turned{WheelEncoders::counted(now.left - instance.start.left, ticks_per_turn_),
                              WheelEncoders::counted(now.right - instance.start.right, ticks_per_turn_)};
      const WheelTurns step{turned.left - instance.counted.left, turned.right - instance.counted.right};
      static_cast<Counter&>(*this).count(space, instance, turned, step, dt);
      instance.counted = turned;
    }
    *instance.readings = instance.state;
  }

  double ticks_per_turn_ = 0.0;
};

}  // namespace swarmanoid::devices
