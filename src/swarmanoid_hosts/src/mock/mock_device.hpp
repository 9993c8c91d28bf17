/// Base of mock devices, which implement the devices of a mock robot. Each is a file in devices/, which the build finds
/// automatically:
///
///     class MockSonar final : public MockDevice {
///      public:
///       MockSonar(Sonar& sonar, MockState&) : sonar_(sonar) {}
///       void sense(const MockState& state) override { sonar_.range = ...; }
///
///      private:
///       Sonar& sonar_;
///     };
///     REGISTER_MOCK_DEVICE(Sonar, MockSonar)
///
/// A device without such a file gets the generic mock: a sensor keeps its readings at rest, an actuator accepts
/// commands and stops safely, without effect. Laws that simulator and mock share are in the device's header.
#pragma once

#include <memory>
#include <string>

#include "mock_state.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::mock {

/// The functions of all devices are called in the order of the phases: all act, the robot moves, all follow, all
/// sense. Within a phase they are called in the order of their types.
class MockDevice {
 public:
  MockDevice() = default;
  virtual ~MockDevice() = default;
  MockDevice(const MockDevice&) = delete;
  MockDevice& operator=(const MockDevice&) = delete;

  /// Carries out a command: turns joints, sets the velocity with which the robot moves next. @param dt [s]
  virtual void act(MockState& /*state*/, double /*dt*/) {}
  /// Updates the state after the robot's motion: held objects move with the robot.
  virtual void follow(MockState& /*state*/) {}
  /// Writes readings.
  virtual void sense(const MockState& /*state*/) {}
  /// Returns whether drivers publish the device's command as its state at each change, because people can see it.
  virtual bool isShown() const { return false; }
};

/// @param device the device's struct, which outlives the mock
using MakeMockDevice = std::unique_ptr<MockDevice> (*)(void* device, MockState& state);

/// @return null for devices that have the generic mock
MakeMockDevice findMockDevice(const std::string& type);

struct MockDeviceRegistration {
  MockDeviceRegistration(const std::string& type, MakeMockDevice make);
};

}  // namespace swarmanoid::mock

/// @param Mock a class with a constructor that takes the device and the state. It is called once, after the world is
/// read and before the robot is placed at `start` and `start_yaw`, so it may set a default pose.
#define REGISTER_MOCK_DEVICE(Device, Mock)                                                                         \
  static const ::swarmanoid::mock::MockDeviceRegistration SWARMANOID_CONCATENATE(mock_registration_, __COUNTER__)( \
      Device::kType,                                                                                               \
      [](void* device, ::swarmanoid::mock::MockState& state) -> std::unique_ptr<::swarmanoid::mock::MockDevice> {  \
        return std::make_unique<Mock>(*static_cast<Device*>(device), state);                                       \
      });
