/// What rviz draws of a space: the arena once, moving things as few markers whose ids stay the same.
///
/// Up to Transforms::kFewRobots robots have the bodies of their URDF, fixed to their frames and sent once, and labels;
/// more of them are spheres of one list for each type. LEDs, laser beams, laser spots and grips are one list each.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <set>
#include <string>
#include <utility>

#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// The floor, its grid, image and patches, the terrain, what nobody moves, and robots' bodies. Replaces what was there
/// before.
visualization_msgs::MarkerArray arenaMarkers(const Space& space);

/// What the engines work with: collision shapes, contacts, joints and forces (EngineDrawing), a list for each engine
/// and kind; those without lines are deleted.
visualization_msgs::MarkerArray engineMarkers(const Space& space);

/// What devices do: a list of lines and one of points for each type of device that has drawn something so far; those
/// that are empty now are deleted. Reuses what `message` holds.
void deviceMarkers(const Space& space, const DeviceDrawings& drawings, visualization_msgs::MarkerArray& message);

class MovingMarkers {
 public:
  /// Valid until the next call. What was drawn the last time and is no more is deleted.
  const visualization_msgs::MarkerArray& draw(const Space& space);

 private:
  visualization_msgs::MarkerArray message_;
  std::set<std::pair<std::string, int>> shown_;
};

}  // namespace swarmanoid
