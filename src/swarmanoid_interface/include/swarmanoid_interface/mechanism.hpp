/// The moving parts of a robot that devices work with and engines simulate. A robot's description lists its wheels,
/// joints and holders but not flight, so any robot may fly. A device names the mechanisms that it needs; an engine
/// accepts or refuses them. So engines do not depend on devices, nor devices on engines.
#pragma once

#include <string>

namespace swarmanoid {

struct Mechanism {
  enum class Kind {
    kWheels,  ///< two driven wheels or treels: a differential drive
    kFlight,  ///< flight as commanded
    kJoint,   ///< a joint that turns a link
    kHolder   ///< a part that holds other entities: a gripper, a hand with suction, a magnet, a rope
  };

  Kind kind = Kind::kWheels;
  /// Name of the joint or holder in the robot's description; "": all of its joints or holders, at least one. Wheels and
  /// flight have no name.
  std::string name = {};
};

inline bool operator==(const Mechanism& a, const Mechanism& b) { return a.kind == b.kind && a.name == b.name; }

}  // namespace swarmanoid
