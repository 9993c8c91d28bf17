/// The base classes of simulated actuators. One object serves all robots of one controller configuration: it takes
/// their commands, checks, limits and disturbs them, and leaves the actuation, which engines and other parts of the
/// tick read.
///
/// Phases   configure, add, remove, stop: between phases. actuate: the phase of this name. afterMove: in `connect`.
/// Noise    drawn from the seat's own stream.
///
/// To add an actuator: write its struct in an interface header, derive from ActuatorOf<Struct>, end with
/// REGISTER_ACTUATOR. The struct has `bool isFinite() const`, and its initial value means "do nothing",
/// which is also its safe stop, unless it has one of its own (swarmanoid_interface/safe_stop.hpp).
#pragma once

#include <algorithm>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/safe_stop.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class Actuator {
 public:
  virtual ~Actuator() = default;

  /// @throws ConfigError
  virtual void configure(const Configuration& parameters) = 0;

  /// Gives a robot its seat. @return where it writes its command, for as long as it lives
  virtual void* add(Space& space, Row row) = 0;
  virtual void remove(Space& space, Row row) = 0;

  /// Commands to actuation. Rows whose command holds a number that is none (NaN, infinite) are added to `faulty`; their
  /// actuation stays what it was.
  virtual void actuate(Space& space, std::vector<Row>& faulty) = 0;
  /// After the engines have moved: what depends on the new poses, such as where a laser beam ends.
  virtual void afterMove(Space&) {}
  /// The robot's command becomes that of its safe stop, and is carried out at once. Starts from the last command that
  /// is sound. @return whether the stop is over: the command stays now
  virtual bool stop(Space& space, Row row, const SafeStopMoment& moment) = 0;

  const char* type() const { return type_; }

 protected:
  explicit Actuator(const char* type) : type_(type) {}

 private:
  const char* type_;
};

template <class Device>
struct BasicActuatorSeat {
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  Device* command = nullptr;
  Device* actuation = nullptr;
  RandomStream random;
};

template <class Device, class Seat = BasicActuatorSeat<Device>>
class ActuatorOf : public Actuator {
 public:
  void* add(Space& space, Row row) override {
    Seat seat;
    seat.row = row;
    seat.number = space.entities.number[static_cast<std::size_t>(row)];
    seat.command = &space.commands.template bank<Device>().add(row);
    seat.actuation = &space.actuation.template bank<Device>().add(row);
    seat.random = RandomStream(space.seed, space.entities.name[static_cast<std::size_t>(row)], Device::kType);
    takeSeat(space, seat);
    Device* command = seat.command;
    seats_.push_back(std::move(seat));
    return command;
  }

  void remove(Space& space, Row row) override {
    space.commands.template bank<Device>().remove(row);
    space.actuation.template bank<Device>().remove(row);
    seats_.erase(std::remove_if(seats_.begin(), seats_.end(), [&](const Seat& seat) { return seat.row == row; }),
                 seats_.end());
  }

  void actuate(Space& space, std::vector<Row>& faulty) override {
    for (Seat& seat : seats_) {
      if (seat.command->isFinite()) {
        *seat.actuation = *seat.command;
        limit(space, seat);
      } else {
        faulty.push_back(seat.row);
      }
      apply(space, seat);
    }
  }

  bool stop(Space& space, Row row, const SafeStopMoment& moment) override {
    bool is_over = true;
    for (Seat& seat : seats_) {
      if (seat.row == row) {
        if (!seat.command->isFinite()) {
          *seat.command = *seat.actuation;
        }
        is_over = stopDevice(*seat.command, moment);
        stopDevice(*seat.actuation, moment);
        apply(space, seat);
      }
    }
    return is_over;
  }

 protected:
  ActuatorOf() : Actuator(Device::kType) {}

  /// Last chance to prepare a new seat, such as from the entity's model.
  virtual void takeSeat(const Space&, Seat&) {}
  /// Limits and noise: changes seat.actuation, which starts as the command.
  virtual void limit(const Space&, Seat&) {}
  /// Carries an actuation out that needs no engine, such as the colour of LEDs.
  virtual void apply(Space&, Seat&) {}

  std::vector<Seat> seats_;

 private:
  static bool stopDevice(Device& device, const SafeStopMoment& moment) {
    if (const SafeStop own = findSafeStop(Device::kType)) {
      return own(&device, moment);
    }
    device = Device{};
    return true;
  }
};

}  // namespace swarmanoid

/// At the end of an actuator's source. `Class` has a static function `PluginDescription describe()`.
#define REGISTER_ACTUATOR(Class)                                                                \
  namespace {                                                                                   \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Actuator, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kActuator, Class::describe());      \
  }
