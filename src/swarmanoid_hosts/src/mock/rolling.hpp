/// Base of mock sensors of wheels: the wheels roll as the robot moves over the ground, and never slip.
#pragma once

#include "mock_device.hpp"

namespace swarmanoid::mock {

/// @tparam Device the struct of the readings
template <class Device>
class RollingDevice : public MockDevice {
 public:
  explicit RollingDevice(Device& readings) : readings_(readings) {}

  void act(MockState& /*state*/, double dt) override { dt_ = dt; }

  void follow(MockState& state) override {
    if (dt_ > 0.0) {
      const double difference = 0.5 * state.twist.yaw_rate * state.world.wheels.separation;
      const double ahead = state.twist.linear.x();
      roll((ahead - difference) * dt_, (ahead + difference) * dt_, state.world.wheels, dt_);
    }
  }

 protected:
  /// @param left, right distances that the wheels have rolled in this period [m] @param dt length of the period [s]
  virtual void roll(double left, double right, const World::Wheels& wheels, double dt) = 0;

  Device& readings_;

 private:
  double dt_ = 0.0;
};

}  // namespace swarmanoid::mock
