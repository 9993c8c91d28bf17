// The writer of radio tags, for any robot with an antenna.
#include "common/tags.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid::devices {
namespace {

struct WriterInstance : BasicActuatorInstance<RfidWriter> {
  Transmitter antenna;

  void archive(StateArchive& /*state*/) {}
};

class RfidWriterActuator final : public ActuatorOf<RfidWriter, WriterInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = RfidWriter::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Writes to one tag within reach of the antenna, the nearest or one that it names.";
    description.parameters = {reachParameter()};
    return description;
  }

  void configure(const Configuration& parameters) override { reach_ = parameters.number("reach"); }

 protected:
  void prepareInstance(const Space& space, WriterInstance& instance) override {
    instance.antenna = antennaOf(*space.entities.model[instance.row], RfidWriter::kType);
  }

  void apply(const Space& space, const ActuateAccess& access, WriterInstance& instance) override {
    const RfidWriter& command = *instance.actuation;
    if (!command.writes || !isAlive(space, instance.row)) {
      return;
    }
    const auto& found = search_.find(space, positionOf(space, instance.row, instance.antenna), reach_);
    const auto meant = std::find_if(found.begin(), found.end(),
                                    [&](const FoundTag& tag) { return command.id == 0 || command.id == tag.id; });
    if (meant != found.end()) {
      write(space, access, meant->row, command.data);
    }
  }

 private:
  /// The last command of a robot remains in the tick in which it is switched off or fails.
  static bool isAlive(const Space& space, Row row) {
    const auto batteries = space.batteries[row];
    const bool is_off = !batteries.empty() && batteries[0].is_empty;
    return !is_off && space.controllers[row].status != StepStatus::kFailed;
  }

  /// Writes a number, unless it is out of the range of the tag's property, which a package may limit.
  static void write(const Space& space, const ActuateAccess& access, Row tag, std::uint32_t data) {
    const EntityModel& model = *space.entities.model[tag];
    const auto place = static_cast<std::size_t>(model.findProperty(kTagData));
    if (model.properties[place].range.contains(data)) {
      access.properties[tag][place] = data;
    }
  }

  double reach_ = Rfid::kUsualReach;  // m
  TagSearch search_;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::RfidWriterActuator)
