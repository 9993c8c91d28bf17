/// Known data of the place where a robot is tested: the parameters of the conformance test.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::conformance {

/// The place where the robot is tested, relative to its start pose. A distance of 0 means that there is no such object.
struct Surroundings {
  Color beacon_color;             ///< of the object straight ahead
  double beacon_distance = 0.6;   ///< [m]
  Color prey_color;               ///< of the object to the left: for a gripper a prey that can be gripped
  double prey_distance = 0.6;     ///< [m]
  double prey_bearing = 0.0;      ///< [rad]
  double wall_distance = 0.0;     ///< from the robot's middle to a wall on its right, along the robot [m]
  double laser_height = 0.0;      ///< of a laser pointer above the ground; 0: not known [m]
  bool has_ceiling = false;       ///< there is a ferromagnetic ceiling above
  bool has_board = false;         ///< an upright board that only the left hand touches with its arm stretched ahead
  bool is_free_upwards = true;    ///< the robot can move up and down
  bool has_sound = false;         ///< there is a sound source that is louder than all others
  bool has_lamp = false;          ///< there is a lamp that is brighter than all others
  Color floor_color;              ///< of the whole floor under the robot
  std::uint32_t tag_id = 0;       ///< of the radio tag below the antenna; 0: there is none
  std::uint32_t tag_data = 0;     ///< data of the tag
  bool has_charger = false;       ///< a charger charges the battery at the start pose
  bool has_exchanger = false;     ///< a battery exchanger is about to act at the start pose
  std::vector<std::size_t> held;  ///< indices of the holders that have an object within reach
  double settling_time = 0.5;     ///< time after a motion until its effect can be measured [s]

  std::string partner;            ///< name of the observer that answers messages; "": there is none
  double partner_distance = 0.0;  ///< between the two transmitters, along the ground; 0: not known [m]
  double partner_bearing = 0.0;   ///< direction of the partner [rad]
  double partner_height = 0.0;    ///< height of its transmitter above the robot's [m]
  double answer_time = 0.5;       ///< from a new message to its answer [s]

  // of an observer
  bool observes_one_color = false;  ///< the other's ring shows one colour, not three
  std::size_t observed_leds = 0;    ///< LEDs in the ring of the observed robot; 0: no ring is observed
  double observed_radius = 0.0;     ///< of that ring [m]
  double observer_bearing = 0.0;    ///< direction of the observer in the observed robot's frame [rad]
  double listening_distance = 0.0;  ///< from its microphones to the other's loudspeaker; 0: not known [m]
};

/// @param usual defaults of the parameters
/// @throws ConfigError
Surroundings readSurroundings(const Configuration& parameters, Surroundings usual);

/// Names of the parameters that readSurroundings reads.
const std::vector<std::string>& surroundingsParameters();

}  // namespace swarmanoid::conformance
