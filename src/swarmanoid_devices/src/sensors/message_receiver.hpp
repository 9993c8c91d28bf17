/// What all devices that receive messages have in common. A receiver reads, in the sense phase of a tick, what senders'
/// actuations were after the tick before: messages arrive in the next tick, whichever robot is updated first, and
/// nothing is kept for them. A message is heard if the two transmitters are within the range of the receiver, with
/// `line_of_sight` nothing but the two robots stands between them, and it is not lost. Nobody hears itself.
///
/// A receiver is its struct, which derives from ReceivedMessages, and a class such as
///
///     class MyRadioReceiver final : public MessageReceiver<MyRadioReceived, MyRadio> {
///      public:
///       static PluginDescription describe() { return describeReceiver("A radio."); }
///     };
///
/// The struct has kUsualRange and kNeedsSight; its Message `payload`, and `measure(offset)`, which takes what the
/// device measures of the sender, if anything, from the offset of its transmitter in the receiver's frame.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "keep_nearest.hpp"
#include "overflow_notes.hpp"
#include "parameters.hpp"
#include "sight_lines.hpp"
#include "span_readings.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "transmitters.hpp"

namespace swarmanoid::devices {

template <class Received>
struct MessageReceiverInstance : SpanReadings<BasicSensorInstance<Received>, typename Received::Message> {
  Transmitter transmitter;
  OverflowNote overflow;
};

/// @tparam Received struct of the readings @tparam Command of the senders' actuators
template <class Received, class Command>
class MessageReceiver : public SensorOf<Received, MessageReceiverInstance<Received>> {
  using Base = SensorOf<Received, MessageReceiverInstance<Received>>;

 public:
  using Instance = MessageReceiverInstance<Received>;
  using Message = typename Received::Message;

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", Received::kUsualRange);
    needs_sight_ = parameters.boolean("line_of_sight", Received::kNeedsSight);
    loss_ = parameters.number("loss", 0.0);
    slots_ = static_cast<std::size_t>(parameters.integer("slots", std::int64_t{Received::kMostMessages}));
  }

  const void* add(Space& space, Row row) override {
    // the bank outlives the sensor, and is there though nobody sends yet
    commands_ = &space.actuation.template bank<Command>();
    return Base::add(space, row);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    // kept between calls so that a steady state allocates nothing
    thread_local Scratch scratch;
    scratch.transmitters.clear();
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k], scratch);
    }
  }

  void report(Space& space) override {
    for (Instance& instance : this->instances_) {
      noteOverflow(space, instance.row, Received::kType, slots_, "messages", instance.readings->overflowed,
                   instance.overflow);
    }
  }

 protected:
  static PluginDescription describeReceiver(const std::string& summary) {
    PluginDescription description;
    description.label = Received::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = summary;
    const std::string most = std::to_string(Received::kMostMessages);
    description.parameters = {
        number("range", "m", numberText(Received::kUsualRange), {0.001, 10000.0},
               "Distance between transmitters beyond which nothing is heard."),
        boolean("line_of_sight", Received::kNeedsSight ? "true" : "false",
                "Whether what stands between transmitters hides them."),
        number("loss", "", "0", {0.0, 1.0}, "Probability with which a message is lost, each by itself."),
        integer("slots", most, {1.0, static_cast<double>(Received::kMostMessages)},
                "Messages reported at the most in one tick, those of the nearest senders.")};
    return description;
  }

  std::size_t mostElements() const override { return slots_; }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.transmitter = transmitterOf(*space.entities.model[instance.row], Received::kType, Command::kLink);
    instance.makeRoom(slots_);
  }

 private:
  /// Somebody in range who sends.
  struct Heard {
    EntityNumber number = kNoEntity;
    Row row = kNoRow;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of the transmitter, in W, m
    double squared_range = 0.0;                          // m2
    const Command* command = nullptr;
    std::size_t place = 0;  // among those in range, by entity number
  };
  struct Scratch {
    std::vector<Row> near;
    std::vector<Heard> heard;
    Transmitters transmitters;
    SightLines lines;
  };

  void senseOne(const Space& space, Instance& instance, Scratch& scratch) const {
    const Eigen::Vector3d own_position = positionOf(space, instance.row, instance.transmitter);
    findInRange(space, instance.row, own_position, scratch);
    leaveOutUnheard(space, instance, own_position, scratch);
    Received& readings = *instance.readings;
    readings.overflowed = keepNearest(scratch.heard, slots_, [](const Heard& each) { return each.squared_range; });
    const Eigen::Matrix3d to_body = space.entities.pose[instance.row].orientation.conjugate().toRotationMatrix();
    for (std::size_t i = 0; i < scratch.heard.size(); ++i) {
      const Heard& heard = scratch.heard[i];
      instance.buffer[i].measure(to_body * (heard.position - own_position));
      instance.buffer[i].payload = heard.command->payload;
    }
    readings.messages = Span<const Message>(instance.buffer.data(), scratch.heard.size());
  }

  /// Fills scratch.near, and scratch.heard with all who send in range, by entity number. @param own_position in W [m]
  void findInRange(const Space& space, Row self, const Eigen::Vector3d& own_position, Scratch& scratch) const {
    scratch.near.clear();
    scratch.heard.clear();
    space.index.collect(own_position, range_ + kMostOutside, scratch.near);
    for (const Row row : scratch.near) {
      const Command* command = row == self ? nullptr : commands_->find(row);
      if (command == nullptr || !command->sends) {
        continue;
      }
      const EntityModel& model = *space.entities.model[row];
      const Eigen::Vector3d position =
          positionOf(space, row, scratch.transmitters.of(model, Command::kType, Command::kLink));
      const double squared_range = (position - own_position).squaredNorm();
      if (squared_range <= range_ * range_) {
        scratch.heard.push_back({space.entities.number[row], row, position, squared_range, command, 0});
      }
    }
    std::sort(scratch.heard.begin(), scratch.heard.end(),
              [](const Heard& a, const Heard& b) { return a.number < b.number; });
    for (std::size_t i = 0; i < scratch.heard.size(); ++i) {
      scratch.heard[i].place = i;
    }
  }

  /// Leaves out whom something hides, and what is lost.
  void leaveOutUnheard(const Space& space, Instance& instance, const Eigen::Vector3d& own_position,
                       Scratch& scratch) const {
    if (needs_sight_ && !scratch.heard.empty()) {
      scratch.lines.begin(space, instance.row, own_position, scratch.near);
    }
    if (loss_ > 0.0) {
      instance.random.startTick(space.tick);
    }
    const auto is_unheard = [&](const Heard& heard) {
      return (needs_sight_ && scratch.lines.isOccluded(heard.position, heard.row)) ||
             (loss_ > 0.0 && instance.random.uniform() < loss_);
    };
    // in their order: each that nothing hides draws a number
    std::size_t kept = 0;
    for (const Heard& heard : scratch.heard) {
      if (!is_unheard(heard)) {
        scratch.heard[kept++] = heard;
      }
    }
    scratch.heard.resize(kept);
  }

  double range_ = Received::kUsualRange;
  bool needs_sight_ = Received::kNeedsSight;
  double loss_ = 0.0;
  std::size_t slots_ = Received::kMostMessages;
  const Bank<Command>* commands_ = nullptr;
};

}  // namespace swarmanoid::devices
