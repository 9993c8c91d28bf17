// A footbot's gripper holds an object near its tip, and carries it along.
#include "swarmanoid_interface/devices/footbot_gripper.hpp"

#include <cmath>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotGripper final : public MockDevice {
 public:
  MockFootbotGripper(const FootbotGripper& command, MockState& /*state*/) : command_(command) {}

  void follow(MockState& state) override {
    Holder& gripper = state.holders["gripper"];
    if (!command_.closed) {
      gripper = Holder{};
      return;
    }
    const double angle = state.joint("turret").angle;
    const Eigen::Vector3d tip =
        state.pose.toWorld({FootbotGripper::kReach * std::cos(angle), FootbotGripper::kReach * std::sin(angle), 0.0});
    if (!gripper.is_holding) {
      grip(state.world, tip, gripper);
    }
    if (gripper.is_holding) {
      state.world.beacons[*gripper.beacon].at.head<2>() = tip.head<2>();
    }
  }

 private:
  static void grip(const World& world, const Eigen::Vector3d& tip, Holder& gripper) {
    constexpr double kNear = 0.06;  // [m] from the tip
    for (std::size_t i = 0; i < world.beacons.size() && !gripper.is_holding; ++i) {
      if (world.beacons[i].can_be_gripped && (world.beacons[i].at - tip).head<2>().norm() < kNear) {
        gripper.is_holding = true;
        gripper.beacon = i;
      }
    }
  }

  const FootbotGripper& command_;
};

REGISTER_MOCK_DEVICE(FootbotGripper, MockFootbotGripper)

}  // namespace
}  // namespace swarmanoid::mock
