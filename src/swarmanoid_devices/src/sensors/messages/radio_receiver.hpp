/// Base class of radio receivers: as all receivers (message_receiver.hpp), but messages have the address of their
/// sender, and messages for other robots are received but not reported.
///
///     class MyRadioReceiver final : public RadioReceiver<MyRadioReceived, MyRadio> {
///      public:
///       static PluginDescription describe() { return describeReceiver("A radio."); }
///     };
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "message_receiver.hpp"
#include "swarmanoid_interface/devices/radio.hpp"

namespace swarmanoid::devices {

template <class Received>
struct RadioReceiverInstance : MessageReceiverInstance<Received> {
  RadioAddress address = kEverybody;  ///< of the robot

  void archive(StateArchive& state) { MessageReceiverInstance<Received>::archive(state); }
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

  void leaveOutOthers(const Instance& instance, std::vector<typename Base::Found>& heard) const override {
    const auto is_for_another = [&](const typename Base::Found& found) {
      const Command& command = found.sender->command;
      return command.to != kEverybody && command.to != instance.address;
    };
    heard.erase(std::remove_if(heard.begin(), heard.end(), is_for_another), heard.end());
  }

  void complete(const Space& space, const std::vector<typename Base::Found>& heard,
                Span<typename Base::Message> messages) const override {
    for (std::size_t i = 0; i < heard.size(); ++i) {
      messages[i].sender = addressOf(space.entities.name[heard[i].sender->row]);
    }
  }
};

}  // namespace swarmanoid::devices
