/// Base class of devices that send messages: their command is the message. Receivers read it in the next tick
/// (sensors/messages/message_receiver.hpp), so nothing is passed on.
///
/// A sender consists of its struct, which derives from MessageCommand and has kLink, and a class such as
///
///     class MyRadioSender final : public MessageSender<MyRadio> {
///      public:
///       static PluginDescription describe() { return describeSender("A radio."); }
///     };
#pragma once

#include <string>

#include "surroundings/transmitters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {

template <class Command>
class MessageSender : public ActuatorOf<Command> {
 public:
  void configure(const Configuration&) override {}

 protected:
  static PluginDescription describeSender(const std::string& summary) {
    PluginDescription description;
    description.label = Command::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = summary;
    return description;
  }

  void prepareInstance(const Space& space, BasicActuatorInstance<Command>& instance) override {
    // receivers rely on this check
    transmitterOf(*space.entities.model[instance.row], Command::kType, Command::kLink);
  }
};

}  // namespace swarmanoid::devices
