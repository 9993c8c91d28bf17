// All holders of any robot: the engine that moves the robot computes holding and winding.
#include "swarmanoid_interface/devices/holders.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class HoldersActuator final : public WinchActuator<HoldersActuator, Holders, Holders::kMost> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Holders::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {allHolders()};
    description.summary = "Takes hold, winds ropes, lets go, with each part that the robot holds with.";
    description.parameters = {fastestWinding()};
    return description;
  }

  static std::array<int, Holders::kMost> indicesIn(const EntityModel& model) {
    return allOf<Holders::kMost>(Holders::kType, model, model.holders.size(), "holders");
  }
  static double& windingOf(Holders& holders, std::size_t which) { return holders.holders[which].winding_speed; }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    for (std::size_t which = 0; which < Holders::kMost; ++which) {
      const Holders::Holder& holder = instance.actuation->holders[which];
      command(access, instance, which, holder.holds, holder.winding_speed);
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HoldersActuator)
