/// The limits of an engine. The simulation asks for them before it adds an entity or hands it over; these functions
/// change nothing.
///
/// Phase    any except during `move`.
/// Reasons  a text that names the unsupported part; "" if there is none.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/time.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

class Space;

/// A device of a controller, and the robot's mechanisms that it uses.
struct DeviceUse {
  std::string type;
  std::vector<Mechanism> mechanisms;
  DeviceKind kind = DeviceKind::kSensor;  ///< an actuator commands its mechanisms
};

class EngineLimits {
 public:
  virtual ~EngineLimits() = default;

  /// Reason why this engine cannot run with ticks of that length; "" if it can. Called once, before entities are added.
  virtual std::string unsupportedClocktickReason(Duration /*clocktick*/) const { return ""; }

  /// Reason why this engine cannot simulate an entity of this model with these devices; "" if it can. The text names
  /// the unsupported device or property. @param devices of the controller
  virtual std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const = 0;

  /// Whether a robot may be moved here although this engine does not support one of its devices. The device is then
  /// idle. This requires that another engine that holds the robot can simulate the device. Example: the rope of a
  /// climbing robot, while other robots carry it over the ground (thesis chapter 5).
  virtual bool mayStandIdle(const EntityModel& /*model*/, const DeviceUse& /*device*/) const { return false; }

  /// Reason why an entity cannot be at that pose, such as "is not in the plane z = 0"; "" if it can. Ignores overlap.
  virtual std::string invalidPoseReason(const EntityModel& model, const Pose& pose) const = 0;

  /// An entity of this engine that a new one at that pose would overlap; kNoRow if there is none.
  /// @param ignored entities that it may overlap, such as itself and the entities connected to it
  virtual Row overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const = 0;
  Row overlap(const EntityModel& model, const Pose& pose, Row ignored) const {
    return overlap(model, pose, Span<const Row>(&ignored, 1));
  }

  /// Reason why this engine could not take over an entity in its present state: its grip in `structure`, if this engine
  /// moved the whole structure, its attachments (`attachments`), and the angles of its joints. The default supports no
  /// grips and no attachments.
  virtual std::string unsupportedStateReason(const Space& space, Row row) const;

 protected:
  /// The part of unsupportedStateReason for an engine that holds no attachments.
  static std::string unsupportedAttachmentReason(const Space& space, Row row);
};

}  // namespace swarmanoid
