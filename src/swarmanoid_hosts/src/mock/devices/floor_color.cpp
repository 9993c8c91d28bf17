// The colour of the discs on the floor of the world, under the robot's middle.
#include "swarmanoid_interface/devices/floor_color.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockFloorColor final : public MockDevice {
 public:
  MockFloorColor(FloorColor& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    readings_.color = floorColorUnder(state.world, state.pose, Eigen::Vector2d::Zero());
  }

 private:
  FloorColor& readings_;
};

REGISTER_MOCK_DEVICE(FloorColor, MockFloorColor)

}  // namespace
}  // namespace swarmanoid::mock
