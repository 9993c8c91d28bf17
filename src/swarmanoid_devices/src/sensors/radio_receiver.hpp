/// What all radios' receivers have in common beside what all receivers have (message_receiver.hpp): messages say who
/// sent them, and what is for another robot is not reported, though it was in the air.
///
///     class MyRadioReceiver final : public RadioReceiver<MyRadioReceived, MyRadio> {
///      public:
///       static PluginDescription describe() { return describeReceiver("A radio."); }
///     };
#pragma once

#include "message_receiver.hpp"
#include "swarmanoid_interface/devices/radio.hpp"

namespace swarmanoid::devices {

template <class Received>
struct RadioReceiverInstance : MessageReceiverInstance<Received> {
  RadioAddress address = kEverybody;  ///< the robot's own
};

/// @tparam Received struct of the readings @tparam Command of the senders' actuators, a RadioCommand
template <class Received, class Command>
class RadioReceiver : public MessageReceiver<Received, Command, RadioReceiverInstance<Received>> {
  using Base = MessageReceiver<Received, Command, RadioReceiverInstance<Received>>;

 public:
  using Instance = typename Base::Instance;

 protected:
  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    instance.address = addressOf(space.entities.name[instance.row]);
  }

  void complete(const Space& space, Row sender, typename Base::Message& message) const override {
    message.sender = addressOf(space.entities.name[sender]);
  }

  bool isFor(const Instance& instance, const Command& command) const override {
    return command.to == kEverybody || command.to == instance.address;
  }
};

}  // namespace swarmanoid::devices
