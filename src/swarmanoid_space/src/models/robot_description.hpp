/// Reads what a robot's URDF says to the suite: one element below <robot>, as Gazebo and ros_control extend URDF.
///
///     <swarmanoid title="Footbot" summary="A wheeled robot with a gripper.">
///       <wheels left="left_wheel" right="right_wheel"/>        joints of a differential drive
///       <gripper name="gripper" link="gripper_tip"/>           or <suction>, <magnet>: holders; the link is where
///       <rope name="rope" link="rope_launcher" length="3"/>    they hold, or where a rope leaves the robot
///       <gripping_strip link="gripping_strip"/>                what grippers of others close on
///       <leds links="led"/>                                    led_0, led_1, ...
///       <device type="eyebot_leds"/>                           devices of other robots that it carries
///       <battery capacity="133200" voltage="3.7"               that it may have [J, V]
///                electronics="3.2"                             what is always on [W]
///                capacitor="60" drive="4" led="0.06"           if there are: super-capacitor [J], drive at full
///                                                              speed [W], white LED [W],
///                rotors="4" rotor_radius="0.09"                rotors, the radius of one [m], and the efficiency
///                rotor_efficiency="0.5"/>                      of them all
///       <consumption device="footbot_camera" power="1"/>       of a device, if it is listed [W]
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
  std::string leds;                          ///< what the names of their links begin with, without "_0"; "": none
  std::vector<std::string> devices;          ///< device types
  std::optional<BatteryModel> battery;       ///< but for `flight`
  /// Of its battery. Nothing: it does not fly, or needs no power for it.
  struct Rotors {
    double area = 0.0;  ///< of all discs [m2]
    double efficiency = 1.0;
  };
  std::optional<Rotors> rotors;
};

/// @param document a URDF; @param file its name, for messages
/// @throws ConfigError with the line if the element is missing, has what it may not have, or names a link or joint that
/// the URDF does not have
RobotDescription readRobotDescription(const xmlDoc& document, const std::string& file);

}  // namespace swarmanoid
