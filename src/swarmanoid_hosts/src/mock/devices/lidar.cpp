// The lidar of any robot measures the walls of the world from the robot's axis, looking ahead.
#include "swarmanoid_interface/devices/lidar.hpp"

#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockLidar final : public MockDevice {
 public:
  MockLidar(Lidar& lidar, MockState& /*state*/) : lidar_(lidar), beams_(Lidar::kUsualBeams) {}

  void act(MockState& /*state*/, double dt) override { lidar_.scan_time = static_cast<float>(dt); }

  void sense(const MockState& state) override {
    constexpr double kAround = 2.0 * M_PI;
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      const double angle =
          Lidar::firstAngle(beams_.size(), kAround) + static_cast<double>(i) * Lidar::increment(beams_.size(), kAround);
      const double way = wayToWall(state.world, state.pose, angle, 0.0);
      beams_[i] = {Distance::reading(way, Lidar::kUsualRange), static_cast<float>(angle)};
    }
    lidar_.beams = beams_;
  }

 private:
  Lidar& lidar_;
  std::vector<LidarBeam> beams_;
};

REGISTER_MOCK_DEVICE(Lidar, MockLidar)

}  // namespace
}  // namespace swarmanoid::mock
