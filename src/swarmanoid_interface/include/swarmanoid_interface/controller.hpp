/// The base class of every controller (thesis 3.3, "Controller Common Interface").
///
/// One object controls one robot. The framework makes it, calls init once, step at every control period, and destroy
/// before it is deleted. The interface is the same for simulated and real robots.
#pragma once

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

class Controller {
 public:
  virtual ~Controller() = default;

  /// Gets the devices of the robot and reads the `<parameters>` of the experiment file.
  /// @throws ConfigError, DeviceError: the controller does not start; the message gives the reason
  virtual void init(Robot& robot, const Configuration& parameters) = 0;

  /// Reads sensors, writes actuators. The steps of several robots run at the same time: this function may use only this
  /// object and its robot. An exception stops this robot, and only this one.
  /// @param time of this tick; @param dt time since the last step
  virtual void step(Time time, Duration dt) = 0;

  /// Returns to the state after init. For code that steps a controller itself, such as its tests. When an experiment is
  /// reset, the framework does not call this function: it destroys the controller and makes another one.
  virtual void reset() {}

  /// Saves or loads all state that steps change (state_archive.hpp), for snapshots of a run; not its devices, its robot
  /// and its random numbers. A controller without such state overrides it with an empty function. The default declares
  /// that the state is not defined: a snapshot of its run is then refused, with the controller's name.
  virtual void archive(StateArchive& state) { state.refuse(); }

  /// Releases what init acquired. An exception is reported; the shutdown of the robot continues.
  virtual void destroy() {}
};

}  // namespace swarmanoid

/// For the end of a controller's source file: makes `Class` available under `label`, the tag in `<controllers>` (thesis
/// 4.1.2). Together with the CMake function swarmanoid_add_controller the controller becomes a nodelet too.
#define REGISTER_CONTROLLER(Class, controller_label)                                              \
  namespace {                                                                                     \
  const ::swarmanoid::PluginRegistration<::swarmanoid::Controller, Class> SWARMANOID_CONCATENATE( \
      registration_, __COUNTER__)(::swarmanoid::PluginKind::kController, [] {                     \
    ::swarmanoid::PluginDescription description;                                                  \
    description.label = (controller_label);                                                       \
    description.free_parameters = true;                                                           \
    return description;                                                                           \
  }());                                                                                           \
  }
