// Contact, length and force of the holders of any robot.
#include <vector>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/holders.hpp"

namespace swarmanoid::mock {
namespace {

class MockHolderStates final : public MockDevice {
 public:
  MockHolderStates(HolderStates& readings, MockState& state) : holders_(state.world.holders.count) {
    readings.holders = holders_;
  }

  void sense(const MockState& state) override {
    for (std::size_t i = 0; i < holders_.size(); ++i) {
      const Holder holder = state.holder(World::Holders::name(i));
      holders_[i] = {holder.is_holding, holder.length, holder.force};
    }
  }

 private:
  std::vector<HolderStates::Holder> holders_;
};

REGISTER_MOCK_DEVICE(HolderStates, MockHolderStates)

}  // namespace
}  // namespace swarmanoid::mock
