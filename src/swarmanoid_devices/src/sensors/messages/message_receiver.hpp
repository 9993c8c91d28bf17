/// Base class of devices that receive messages. In the sense phase of a tick, a receiver reads the senders' actuations
/// of the previous tick: messages arrive in the next tick, independent of the order of updates, and are not stored. A
/// message is received if the two transmitters are within the range of the receiver, if with `line_of_sight` nothing
/// but the two robots is between them, and if it is not lost (LossLaw). A robot does not receive its own messages.
///
/// A receiver consists of its struct, which derives from ReceivedMessages, and a class such as
///
///     class MyBoardReceiver final : public MessageReceiver<MyBoardReceived, MyBoard> {
///      public:
///       static PluginDescription describe() { return describeReceiver("A board."); }
///     };
///
/// The struct has kUsualRange and kNeedsSight. Its Message has `payload`, and `measure(offset)`, which sets the
/// measurements of the sender, if any, from the offset of its transmitter in the receiver's frame.
///
/// A radio derives from RadioReceiver (radio_receiver.hpp) and has kSharesChannel: `slots` then counts all messages on
/// the channel around it, for any receiver. Messages for other receivers are dropped afterwards, so a receiver searches
/// only as far as needed to fill the slots.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "common/keep_nearest.hpp"
#include "common/loss_law.hpp"
#include "common/overflow_notes.hpp"
#include "common/parameters.hpp"
#include "common/span_readings.hpp"
#include "sender_search.hpp"
#include "surroundings/sight_lines.hpp"
#include "surroundings/transmitters.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

template <class Received>
struct MessageReceiverInstance : SpanReadings<BasicSensorInstance<Received>, typename Received::Message> {
  Transmitter transmitter;
  OverflowNote overflow;
  double reach = 1.0;  ///< on a shared channel: search distance of the last tick, with which the next one starts [m]
  std::vector<EntityNumber> senders;  // of the messages of this tick, for drawing

  void archive(StateArchive& state) {
    SpanReadings<BasicSensorInstance<Received>, typename Received::Message>::archive(state);
    state(overflow, reach, senders);
  }
};

/// @tparam Received struct of the readings @tparam Command of the senders' actuators
template <class Received, class Command, class InstanceOfReceiver = MessageReceiverInstance<Received>>
class MessageReceiver : public SensorOf<Received, InstanceOfReceiver> {
  using Base = SensorOf<Received, InstanceOfReceiver>;

 public:
  using Instance = InstanceOfReceiver;
  using Message = typename Received::Message;

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", Received::kUsualRange);
    needs_sight_ = parameters.boolean("line_of_sight", Received::kNeedsSight);
    loss_ = LossLaw(parameters, range_);
    slots_ = static_cast<std::size_t>(parameters.integer("slots", std::int64_t{Received::kMostMessages}));
  }

  const void* add(Space& space, Row row) override {
    // the bank outlives the sensor, and exists even without senders
    commands_ = &space.actuation.template bank<Command>();
    return Base::add(space, row);
  }

  void prepare(const Space& space) override {
    if (this->instances_.empty()) {
      return;  // no robot has the sensor at present
    }
    // lines of sight need all nearby robots, not only the senders
    const bool may_be_few = Received::kSharesChannel && !needs_sight_;
    table_.fill(space, *commands_, may_be_few ? slots_ : 0);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    // kept between calls so that a steady state allocates nothing
    thread_local Scratch scratch;
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k], scratch);
    }
  }

  void report(const Space& space, const ReportAccess& access) override {
    for (Instance& instance : this->instances_) {
      noteOverflow(space, access, instance.row, Received::kType, slots_, "messages", instance.readings->overflowed,
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
               "Maximum range, between transmitters."),
        boolean("line_of_sight", Received::kNeedsSight ? "true" : "false", "Whether obstacles block reception."),
        number("loss", "", "0", {0.0, 1.0}, "Loss probability of each message, independent of others."),
        number("loss_at_range", "", numberText(Received::kUsualLossAtRange), {0.0, 1.0},
               "Additional loss probability at maximum range."),
        integer("loss_exponent", "2", {1.0, 8.0}, "Exponent of the increase of that probability with distance."),
        integer("slots", most, {1.0, static_cast<double>(Received::kMostMessages)},
                Received::kSharesChannel
                    ? "Maximum number of messages in one tick, for any receiver; the nearest senders have priority."
                    : "Maximum number of messages reported in one tick; the nearest senders have priority.")};
    return description;
  }

  std::size_t mostElements() const override { return slots_; }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.transmitter = transmitterOf(*space.entities.model[instance.row], Received::kType, Command::kLink);
    instance.makeRoom(slots_);
    instance.senders.resize(slots_);
  }

  /// Draws the links of this tick: a line to the transmitter of each received sender, before errors and faults, and a
  /// point at the receiver's end.
  void drawOne(const Space& space, const Instance& instance, DeviceDrawing& drawing) const override {
    thread_local Transmitters transmitters;
    transmitters.clear();
    const Eigen::Vector3d own_position = positionOf(space, instance.row, instance.transmitter);
    for (std::size_t i = 0; i < instance.readings->messages.size(); ++i) {
      const Row sender = space.entities.find(instance.senders[i]);
      if (sender != kNoRow) {
        const Transmitter& transmitter = transmitters.of(*space.entities.model[sender], Command::kType, Command::kLink);
        const Eigen::Vector3d position = positionOf(space, sender, transmitter);
        drawing.line(position, own_position, colors::kMagenta);
        drawing.point(own_position, colors::kMagenta);
      }
    }
  }

  using Search = SenderSearch<Command>;
  using Found = typename Search::Found;

  /// Removes the senders of messages for other robots.
  virtual void leaveOutOthers(const Instance&, std::vector<Found>&) const {}
  /// Fills the fields of messages that are neither sent nor measured. @param heard their senders, in the same order
  virtual void complete(const Space&, const std::vector<Found>& /*heard*/, Span<Message>) const {}

 private:
  /// Offsets from the receiver to the senders, in the frame of its robot [m]: by coordinate, so that the loop over
  /// messages can be vectorised.
  struct Offsets {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;

    void fit(std::size_t count) {
      for (std::vector<double>* column : {&x, &y, &z}) {
        column->resize(std::max(column->size(), count));
      }
    }
  };
  struct Scratch {
    Search senders;
    SightLines lines;
    Offsets offsets;
  };

  void senseOne(const Space& space, Instance& instance, Scratch& scratch) const {
    const Eigen::Vector3d own_position = positionOf(space, instance.row, instance.transmitter);
    if constexpr (Received::kSharesChannel) {
      hearNearest(space, instance, own_position, scratch);
      scratch.senders.sort();
    } else {
      findInSight(space, instance, own_position, range_, scratch);
      scratch.senders.sort();
      leaveOutLost(space, instance, scratch.senders.found);
    }
    std::vector<Found>& heard = scratch.senders.found;
    Received& readings = *instance.readings;
    readings.overflowed = keepNearest(heard, slots_, [](const Found& each) { return each.squared_range; });
    leaveOutOthers(instance, heard);
    measure(space, instance, own_position, heard, scratch.offsets);
    const Span<Message> messages(instance.buffer.data(), heard.size());
    complete(space, heard, messages);
    readings.messages = messages;
  }

  /// Fills messages with payloads and measurements.
  void measure(const Space& space, Instance& instance, const Eigen::Vector3d& own_position,
               const std::vector<Found>& heard, Offsets& offsets) const {
    const Eigen::Matrix3d to_body = space.entities.pose[instance.row].orientation.conjugate().toRotationMatrix();
    offsets.fit(heard.size());
    for (std::size_t i = 0; i < heard.size(); ++i) {
      const Sender<Command>& sender = *heard[i].sender;
      const Eigen::Vector3d offset = to_body * (sender.position - own_position);
      offsets.x[i] = offset.x();
      offsets.y[i] = offset.y();
      offsets.z[i] = offset.z();
      instance.senders[i] = sender.number;
      instance.buffer[i].payload = sender.command.payload;
    }
    // a separate loop without calls or branches, so that compilers vectorise it
    for (std::size_t i = 0; i < heard.size(); ++i) {
      instance.buffer[i].measure({offsets.x[i], offsets.y[i], offsets.z[i]});
    }
  }

  /// Finds all senders that are received up to a search distance, which is doubled until it contains more senders than
  /// slots, or reaches the range.
  void hearNearest(const Space& space, Instance& instance, const Eigen::Vector3d& own_position,
                   Scratch& scratch) const {
    constexpr std::size_t kFarTooMany = 4;  // times the slots: the next search starts with half the distance
    constexpr double kNearest = 1e-3;       // m, lower bound, so that it can grow again
    const std::vector<Found>& heard = scratch.senders.found;
    const bool looks_around = table_.few() == nullptr;
    double reach = looks_around ? std::min(range_, instance.reach) : range_;
    while (true) {
      findInSight(space, instance, own_position, reach, scratch);
      leaveOutLost(space, instance, scratch.senders.found);
      if (heard.size() > slots_ || reach >= range_) {
        break;
      }
      reach = std::min(range_, 2.0 * reach);
    }
    if (looks_around) {
      instance.reach = heard.size() > kFarTooMany * slots_ ? std::max(0.5 * reach, kNearest) : reach;
    }
  }

  /// Finds the senders within a distance that nothing hides, in unspecified order.
  void findInSight(const Space& space, const Instance& instance, const Eigen::Vector3d& own_position, double reach,
                   Scratch& scratch) const {
    scratch.senders.find(space, table_, instance.row, own_position, reach);
    std::vector<Found>& found = scratch.senders.found;
    if (needs_sight_ && !found.empty()) {
      scratch.lines.begin(space, instance.row, own_position, reach + kMostOutside, scratch.senders.near);
      leaveOut(found,
               [&](const Found& each) { return scratch.lines.isOccluded(each.sender->position, each.sender->row); });
    }
  }

  /// @param found in the order of entity numbers if the channel is not shared, since each draws a random number
  void leaveOutLost(const Space& space, Instance& instance, std::vector<Found>& found) const {
    if (!loss_.loses()) {
      return;
    }
    instance.random.startTick(space.tick);
    const std::uint64_t draws = Received::kSharesChannel ? instance.random.bits() : 0;
    leaveOut(found, [&](const Found& each) {
      const double probability = loss_.probability(each.squared_range);
      if constexpr (Received::kSharesChannel) {
        // a random stream for each pair, so that the loss does not depend on the search distance
        RandomStream pair(draws, static_cast<std::uint64_t>(each.sender->number));
        return pair.uniform() < probability;
      } else {
        return instance.random.uniform() < probability;
      }
    });
  }

  /// Removes elements for which is_out is true. Calls it once for each, in order; the order is kept.
  template <class IsOut>
  static void leaveOut(std::vector<Found>& found, IsOut is_out) {
    std::size_t kept = 0;
    for (const Found& each : found) {
      const bool is_kept = !is_out(each);
      found[kept] = each;
      kept += is_kept ? 1 : 0;
    }
    found.resize(kept);
  }

  double range_ = Received::kUsualRange;
  bool needs_sight_ = Received::kNeedsSight;
  LossLaw loss_;
  std::size_t slots_ = Received::kMostMessages;
  const Bank<Command>* commands_ = nullptr;
  SenderTable<Command> table_;  // of this tick
};

}  // namespace swarmanoid::devices
