#include "network_outputs.hpp"

#include "swarmanoid_interface/list_sectors.hpp"

namespace swarmanoid::neural {

NetworkOutputs::NetworkOutputs(Robot& robot, const Configuration& outputs) {
  for (Port& port : portsOf(robot, outputs, DeviceKind::kActuator)) {
    if (port.span != nullptr) {
      refuse(port, ", which is in a list", "fields that are in none");
    }
    takeCount(port);
    auto* device = static_cast<std::byte*>(robot.actuator(port.type->type));
    if (port.parameters->has("constant")) {
      const double value = port.parameters->number("constant", scalingBoundsOf(*port.field));
      port.parameters->refuseUnread({"count", "constant"});
      for (const NumberPlace& place : port.places) {
        constants_.push_back({device, place, {value, value}});
      }
      continue;
    }
    takeRange(port);
    port.parameters->refuseUnread({"minimum", "maximum", "count", "constant"});
    for (const NumberPlace& place : port.places) {
      targets_.push_back({device, place, port.range});
    }
  }
  if (targets_.empty()) {
    throw ConfigError(outputs.location(),
                      "found <outputs> without a field that the network commands, allowed: at least one");
  }
}

void NetworkOutputs::write(const std::vector<double>& values) const {
  for (const Target& constant : constants_) {
    constant.place.write(constant.device, constant.range.minimum);
  }
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    target.place.write(target.device, target.range.minimum + values[i] * (target.range.maximum - target.range.minimum));
  }
}

}  // namespace swarmanoid::neural
