/// The moving parts of a robot that devices work with and engines simulate. A robot's description says which wheels,
/// joints and holders it has; of flight it says nothing, so any robot may fly. A device names those that it needs; an
/// engine accepts or refuses them. So engines know no devices, and devices no engines.
#pragma once

#include <string>

namespace swarmanoid {

struct Mechanism {
  enum class Kind {
    kWheels,  ///< two driven wheels or treels: a differential drive
    kFlight,  ///< it flies as it is commanded
    kJoint,   ///< a joint that turns a link
    kHolder   ///< a part that holds on to other entities: a gripper, a hand with suction, a magnet, a rope
  };

  Kind kind = Kind::kWheels;
  /// Of the joint or the holder in the robot's description; "": all joints or holders that it has, of which there is
  /// one at least. The others have no name.
  std::string name = {};
};

inline bool operator==(const Mechanism& a, const Mechanism& b) { return a.kind == b.kind && a.name == b.name; }

}  // namespace swarmanoid
