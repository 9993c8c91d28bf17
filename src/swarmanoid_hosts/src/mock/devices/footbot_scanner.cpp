// The head of a footbot's scanner turns. It is the joint "scanner" of the robot's state, which exists while the scanner
// is on.
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotScanner final : public MockDevice {
 public:
  MockFootbotScanner(const FootbotScanner& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    const double turn = command_.turnFrom(angle_, dt);
    angle_ = wrapTurn(angle_ + turn);
    if (command_.mode == FootbotScanner::Mode::kOff) {
      state.joints.erase("scanner");
    } else {
      state.joints["scanner"] = {angle_, turn / dt};
    }
  }

 private:
  const FootbotScanner& command_;
  double angle_ = 0.0;  // rad
};

REGISTER_MOCK_DEVICE(FootbotScanner, MockFootbotScanner)

}  // namespace
}  // namespace swarmanoid::mock
