// State of all holders of any robot. Bodies held by grippers are in the structural tree, all others in the attachments.
#include "common/holders.hpp"
#include "common/span_readings.hpp"
#include "swarmanoid_interface/devices/holders.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyHolderStates = SpanReadings<BasicSensorInstance<HolderStates>, HolderStates::Holder>;

class HolderStatesSensor final
    : public HolderSensor<HolderStatesSensor, HolderStates, HolderStates::kMost, RoomyHolderStates> {
  using Base = HolderSensor<HolderStatesSensor, HolderStates, HolderStates::kMost, RoomyHolderStates>;

 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HolderStates::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Whether each holder holds an object, the length of its rope, and the force on the object.";
    return description;
  }

  static std::array<int, HolderStates::kMost> indicesIn(const EntityModel& model) {
    return allOf<HolderStates::kMost>(HolderStates::kType, model, model.holders.size(), "holders");
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      Instance& instance = instances_[k];
      const std::vector<EntityModel::Holder>& holders = space.entities.model[instance.row]->holders;
      for (std::size_t i = 0; i < instance.buffer.size(); ++i) {
        if (holders[i].kind == EntityModel::Holder::Kind::kGripper) {  // a robot has at most one
          instance.buffer[i].is_holding = space.structure.grippedBy(instance.row) != kNoRow;
        } else {
          const Attachment attachment = attachmentOf(space, instance, i);
          instance.buffer[i] = {attachment.held != kNoRow, attachment.length, attachment.force};
        }
      }
    }
  }

 protected:
  std::size_t mostElements() const override { return HolderStates::kMost; }

  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    instance.readings->holders = instance.makeRoom(space.entities.model[instance.row]->holders.size());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HolderStatesSensor)
