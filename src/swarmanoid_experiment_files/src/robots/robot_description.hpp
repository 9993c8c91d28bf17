/// Reads the suite's own element of a robot's URDF, one below <robot>; Gazebo and ros_control extend URDF in the same
/// way.
///
///     <swarmanoid title="Footbot" summary="A wheeled robot with a gripper.">
///       <wheels left="left_wheel" right="right_wheel"/>        joints of a differential drive
///       <gripper name="gripper" link="gripper_tip"/>           or <suction>, <magnet>: holders; the link is where
///       <rope name="rope" link="rope_launcher" length="3"/>    they hold, or where a rope leaves the robot
///       <gripping_strip link="gripping_strip"/>                target for the grippers of other robots
///       <leds links="led"/>                                    led_0, led_1, ...
///       <device type="eyebot_leds"/>                           devices of other robot types that it has
///       <battery capacity="133200" voltage="3.7"               optional battery [J, V]
///                electronics="3.2"                             continuous consumption [W]
///                capacitor="60" drive="4" led="0.06"           optional: super-capacitor [J], drive at full
///                                                              speed [W], white LED [W],
///                rotors="4" rotor_radius="0.09"                number of rotors, radius [m], and efficiency
///                rotor_efficiency="0.5"/>                      of all rotors
///       <consumption device="footbot_camera" power="1"/>       of a device, if the controller lists it [W]
///     </swarmanoid>
#pragma once

#include <libxml/tree.h>

#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

struct RobotDescription {
  /// Names of joints.
  struct Wheels {
    std::string left;
    std::string right;
  };

  std::string title;    ///< one word, as in EntityModel
  std::string summary;  ///< one sentence
  std::optional<Wheels> wheels;
  std::vector<EntityModel::Holder> holders;  ///< in the order of the file; at most one is a gripper
  std::string gripping_strip;                ///< a link; "": it has none
  std::string leds;                          ///< prefix of the names of their links, without "_0"; "": none
  std::vector<std::string> devices;          ///< device types
  std::optional<BatteryModel> battery;       ///< without `flight`
  /// Rotors that the battery drives. Empty: the robot does not fly, or flies without battery power.
  struct Rotors {
    double area = 0.0;  ///< of all discs [m2]
    double efficiency = 1.0;
  };
  std::optional<Rotors> rotors;
};

/// @param document a URDF; @param file its name, for messages
/// @throws ConfigError with the line if the element is missing, contains anything that is not allowed, or names a link
/// or joint that the URDF does not have
RobotDescription readRobotDescription(const xmlDoc& document, const std::string& file);

}  // namespace swarmanoid
