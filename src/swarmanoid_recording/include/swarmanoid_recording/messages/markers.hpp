/// Markers of a space for rviz: the arena once, moving entities as few markers with constant ids.
///
/// Up to Transforms::kFewRobots robots have the bodies of their URDF, fixed to their frames and sent once, and labels;
/// a larger number of robots is drawn as spheres, in one list for each type. LEDs, laser beams, laser spots and grips
/// are one list each.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// The floor, its grid, image and patches, the terrain, fixed entities, and robots' bodies. Replaces all previous
/// markers of the arena.
visualization_msgs::MarkerArray arenaMarkers(const Space& space);

/// The internal state of engines: collision shapes, contacts, joints and forces (EngineDrawing), a list for each engine
/// and kind; deletes empty lists.
visualization_msgs::MarkerArray engineMarkers(const Space& space);

/// Drawings of devices: a list of lines and one of points for each type of device that has drawn anything so far;
/// deletes lists that have become empty. Reuses the memory of `message`.
void deviceMarkers(const Space& space, const DeviceDrawings& drawings, visualization_msgs::MarkerArray& message);

class MovingMarkers {
 public:
  /// Valid until the next call. Deletes markers of the previous call that no longer exist.
  const visualization_msgs::MarkerArray& draw(const Space& space);

 private:
  visualization_msgs::MarkerArray message_;
  std::set<std::pair<std::string, int>> shown_;
};

}  // namespace swarmanoid
