// The gauge of a robot's battery.
#include "swarmanoid_interface/devices/battery.hpp"

#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

class BatterySensor final : public SensorOf<Battery> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Battery::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Remaining charge and power of the battery, for robots with a battery.";
    return description;
  }

  void configure(const Configuration&) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Row row = instances_[k].row;
      senseOne(*space.entities.model[row]->battery, space.properties[row], space.batteries[row][0],
               *instances_[k].readings);
    }
  }

 protected:
  void prepareInstance(const Space& space, BasicSensorInstance<Battery>& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    if (!model.battery) {
      throw ConfigError({}, "battery: found a " + model.type + " without one, allowed: " +
                                (model.possible_battery ? "robots with <battery>true</battery>"
                                                        : "robots whose description has a <battery>"));
    }
    senseOne(*model.battery, space.properties[instance.row], space.batteries[instance.row][0], *instance.readings);
  }

 private:
  static void senseOne(const BatteryModel& model, Span<const double> stores, const BatteryState& state,
                       Battery& battery) {
    battery.charge = static_cast<float>(stores[kBatteryCharge]);
    battery.capacity = static_cast<float>(model.capacity);
    battery.voltage = static_cast<float>(model.voltage);
    battery.power = static_cast<float>(state.power - state.input);
    battery.is_charging = stores[kBatterySupply] > 0.0;
    battery.on_capacitor = isOnCapacitor(stores, state);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::BatterySensor)
