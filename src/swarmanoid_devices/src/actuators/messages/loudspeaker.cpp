// The loudspeaker of any robot. Microphones read its actuation (sound_sources.hpp), so nothing is passed on.
#include "swarmanoid_interface/devices/loudspeaker.hpp"

#include "surroundings/transmitters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class LoudspeakerActuator final : public ActuatorOf<Loudspeaker> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Loudspeaker::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Emits a tone for all microphones within their range, until it falls silent.";
    return description;
  }

  void configure(const Configuration&) override {}

 protected:
  void prepareInstance(const Space& space, BasicActuatorInstance<Loudspeaker>& instance) override {
    // microphones rely on this check
    transmitterOf(*space.entities.model[instance.row], Loudspeaker::kType, Loudspeaker::kLink);
  }

  void limit(const Space& /*space*/, BasicActuatorInstance<Loudspeaker>& instance) override {
    limitToRanges(*instance.actuation);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::LoudspeakerActuator)
