/// Base classes of devices that use holders of a robot (EntityModel::Holder): grippers, hands, magnets, ropes and their
/// winches.
/// The indices of the holders in the model are looked up once, when a robot is added.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "mechanisms.hpp"
#include "parameters.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

// Names in the model of the holders that both an actuator and a sensor use.
inline constexpr std::array<const char*, 1> kMagnetHolder{"magnet"};
inline constexpr std::array<const char*, 1> kRopeHolder{"rope"};
inline constexpr std::array<const char*, 2> kHandHolders{"left hand", "right hand"};

/// An instance with the indices of `count` holders in the model; -1 for missing ones.
template <class Instance, std::size_t count>
struct WithHolders : Instance {
  std::array<int, count> holders{};

  /// For snapshots: the indices follow from the model.
  void archive(StateArchive& state) {
    if constexpr (StateArchive::kIsDefinedBy<Instance>) {
      Instance::archive(state);
    }
  }
};

template <std::size_t count>
std::array<int, count> holdersOf(const EntityModel& model, const std::array<const char*, count>& names) {
  std::array<int, count> holders{};
  for (std::size_t i = 0; i < count; ++i) {
    holders[i] = model.findHolder(names[i]);
  }
  return holders;
}

/// `Derived` has `static constexpr std::array<const char*, count> kHolders`, the names of its holders, or its own
/// `indicesIn`.
template <class Derived, class Device, std::size_t count = 1>
class HolderActuator : public ActuatorOf<Device, WithHolders<BasicActuatorInstance<Device>, count>> {
 public:
  using Instance = WithHolders<BasicActuatorInstance<Device>, count>;

  static std::array<int, count> indicesIn(const EntityModel& model) { return holdersOf(model, Derived::kHolders); }

  void configure(const Configuration&) override {}

 protected:
  void prepareInstance(const Space& space, Instance& instance) override {
    instance.holders = Derived::indicesIn(*space.entities.model[instance.row]);
  }

  /// @param winding_speed of a rope [m/s]
  static void command(const ActuateAccess& access, const Instance& instance, std::size_t which, bool holds,
                      double winding_speed = 0.0) {
    const int holder = instance.holders[which];
    if (holder >= 0) {
      access.holder_commands[instance.row][static_cast<std::size_t>(holder)] = {true, holds, winding_speed};
    }
  }
};

/// Holders of which some are ropes, with winches of limited speed. `Derived` also has `static double&
/// windingOf(Device&, std::size_t which)`, the winding speed of each holder, and `Device` has `kUsualFastest` [m/s].
template <class Derived, class Device, std::size_t count = 1>
class WinchActuator : public HolderActuator<Derived, Device, count> {
 public:
  using typename HolderActuator<Derived, Device, count>::Instance;

  void configure(const Configuration& parameters) override {
    max_speed_ = parameters.number("max_speed", Device::kUsualFastest);
  }

 protected:
  static Parameter fastestWinding() {
    return number("max_speed", "m/s", numberText(Device::kUsualFastest), {0.0, 2.0},
                  "The fastest winding, in and out.");
  }

  void limit(const Space& /*space*/, Instance& instance) override {
    for (std::size_t which = 0; which < count; ++which) {
      double& speed = Derived::windingOf(*instance.actuation, which);
      speed = std::clamp(speed, -max_speed_, max_speed_);
    }
  }

 private:
  double max_speed_ = Device::kUsualFastest;
};

/// As HolderActuator, for sensors.
template <class Derived, class Device, std::size_t count = 1, class InstanceWithout = BasicSensorInstance<Device>>
class HolderSensor : public SensorOf<Device, WithHolders<InstanceWithout, count>> {
 public:
  using Instance = WithHolders<InstanceWithout, count>;

  static std::array<int, count> indicesIn(const EntityModel& model) { return holdersOf(model, Derived::kHolders); }

  void configure(const Configuration&) override {}

 protected:
  void prepareInstance(const Space& space, Instance& instance) override {
    instance.holders = Derived::indicesIn(*space.entities.model[instance.row]);
  }

  /// @return an attachment to nothing if the robot does not have the holder
  static Attachment attachmentOf(const Space& space, const Instance& instance, std::size_t which) {
    const int holder = instance.holders[which];
    return holder < 0 ? Attachment{} : space.attachments.of(instance.row, static_cast<std::size_t>(holder));
  }
};

}  // namespace swarmanoid::devices
