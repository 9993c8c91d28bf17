// The light sensors of any robot sense the beacons of the world, from the ring that the world's values describe, on the
// ground.
#include "swarmanoid_interface/devices/light.hpp"

#include <cmath>
#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockLight final : public MockDevice {
 public:
  MockLight(Light& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const World::Ring& ring = state.world.ring;
    sensors_.resize(ring.sensors);
    for (std::size_t i = 0; i < ring.sensors; ++i) {
      const double angle = ring.angle(i);
      const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
      sensors_[i] = {readingOf(state, direction), static_cast<float>(angle)};
    }
    readings_.sensors = sensors_;
  }

 private:
  /// @param direction in which the sensor looks, in the robot's frame
  static float readingOf(const MockState& state, const Eigen::Vector3d& direction) {
    double sum = 0.0;
    for (const Beacon& beacon : state.world.beacons) {
      const Eigen::Vector3d offset = state.pose.toRobot(beacon.at) - state.world.ring.radius * direction;
      if (offset.norm() <= Light::kUsualRange) {
        sum += Light::share(Light::brightness(beacon.color), direction, offset);
      }
    }
    return Light::response(sum);
  }

  Light& readings_;
  std::vector<LightReading> sensors_;
};

REGISTER_MOCK_DEVICE(Light, MockLight)

}  // namespace
}  // namespace swarmanoid::mock
