// The motor of the rotating distance scanner: the command is limited. The sensor turns the head, which engines ignore.
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotScannerActuator final : public ActuatorOf<FootbotScanner> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotScanner::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Turns the head of the distance scanner, at a speed or to an angle, or switches it off.";
    return description;
  }

  void configure(const Configuration&) override {}

 protected:
  void limit(const Space& /*space*/, BasicActuatorInstance<FootbotScanner>& instance) override {
    limitToRanges(*instance.actuation);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotScannerActuator)
