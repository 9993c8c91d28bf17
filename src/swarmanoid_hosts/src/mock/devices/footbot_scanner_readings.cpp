// The beams of a footbot's scanner measure the walls of the world.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

namespace swarmanoid::mock {
namespace {

using Readings = FootbotScannerReadings;

class MockFootbotScannerReadings final : public MockDevice {
 public:
  MockFootbotScannerReadings(Readings& readings, MockState& /*state*/) : readings_(readings) {}

  void act(MockState& /*state*/, double dt) override { dt_ = dt; }

  void sense(const MockState& state) override {
    const auto head = state.joints.find("scanner");
    if (head == state.joints.end()) {
      const double angle = readings_.angle;
      readings_ = {};
      readings_.angle = angle;
      readings_.period = static_cast<float>(dt_);
      readings_.angles.fill(static_cast<float>(angle));
      return;
    }
    const double turn = head->second.speed * dt_;
    readings_.angle = head->second.angle;
    readings_.period = static_cast<float>(dt_);
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      const double angle = Readings::angleOf(i, readings_.angle - turn, turn);
      readings_.angles[i] = static_cast<float>(wrapTurn(angle));
      for (std::size_t beam = 0; beam < Readings::kBeams; ++beam) {
        const double way = wayToWall(state.world, state.pose, angle + Readings::offset(beam), 0.0);
        readings_.distances(beam)[i] = Distance::reading(way, Readings::rangeOf(beam));
      }
    }
  }

 private:
  Readings& readings_;
  double dt_ = 0.0;  // of the last tick, s
};

REGISTER_MOCK_DEVICE(FootbotScannerReadings, MockFootbotScannerReadings)

}  // namespace
}  // namespace swarmanoid::mock
