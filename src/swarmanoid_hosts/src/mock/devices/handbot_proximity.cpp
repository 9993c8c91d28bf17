// The sensor in a handbot's palm senses the object that its hand would hold, if the world has one, while the arm is
// level.
#include "swarmanoid_interface/devices/handbot_proximity.hpp"

#include <cmath>
#include <string>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbotProximity final : public MockDevice {
 public:
  MockHandbotProximity(HandbotProximity& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    readings_.left = read(state, "left_shoulder", state.world.is_something_left);
    readings_.right = read(state, "right_shoulder", state.world.is_something_right);
  }

 private:
  static float read(const MockState& state, const char* shoulder, bool is_something) {
    constexpr double kLevel = 0.1;  // [rad]: the arm counts as stretched out
    return is_something && std::abs(state.joint(shoulder).angle) < kLevel ? 1.0F : 0.0F;
  }

  HandbotProximity& readings_;
};

REGISTER_MOCK_DEVICE(HandbotProximity, MockHandbotProximity)

}  // namespace
}  // namespace swarmanoid::mock
