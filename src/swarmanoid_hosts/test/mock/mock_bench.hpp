/// A mock robot for tests, with its devices by their structs.
#pragma once

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../src/mock/mock_robot.hpp"

namespace swarmanoid::mock {

inline constexpr double kStep = 0.02;  // [s]

inline const SourceLocation kHere{"/m", 0};

struct Bench {
  explicit Bench(const std::string& type, const World& world = {}) : Bench(devicesOf(type, {}, kHere), world) {}
  Bench(const std::string& type, const World& world, const Pose& start) : Bench(type, world) { robot->place(start); }
  explicit Bench(const std::vector<std::string>& devices, const World& world = {})
      : robot(std::make_unique<MockRobot>(devices, world)) {}

  template <class Device>
  Device& command() {
    return *static_cast<Device*>(robot->devices()[indexOf<Device>()].value.get());
  }
  template <class Device>
  const Device& reading() const {
    return *static_cast<const Device*>(robot->devices()[indexOf<Device>()].value.get());
  }
  template <class Device>
  std::size_t indexOf() const {
    const MockRobot::Device* device = robot->find(Device::kType);
    if (device == nullptr) {
      throw std::logic_error(std::string("no ") + Device::kType);
    }
    return static_cast<std::size_t>(device - robot->devices().data());
  }
  void advance(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
      robot->advance(kStep);
    }
  }

  std::unique_ptr<MockRobot> robot;
};

inline World worldWith(Beacon beacon) {
  World world;
  world.beacons.push_back(std::move(beacon));
  return world;
}

/// A grey disc and a green one, which lies on the grey one where they overlap.
inline World worldWithDiscs() {
  World world;
  world.discs.push_back({{0.17, 0.25}, 0.06, colors::kGray});
  world.discs.push_back({{0.1, 0.25}, 0.045, colors::kGreen});
  return world;
}

}  // namespace swarmanoid::mock
