/// Where an entity is put that is dragged over the horizontal plane in which its origin lies. No Ogre and no Qt here.
///
/// Frames  world; lengths in m.
#pragma once

#include <geometry_msgs/Pose.h>

namespace swarmanoid {

class Drag {
 public:
  /// The pointer took hold of the entity at this point of the plane.
  Drag(const geometry_msgs::Pose& pose, double x, double y) : start_(pose), pose_(pose), grip_x_(x), grip_y_(y) {}

  /// The height of the plane.
  double height() const { return start_.position.z; }

  /// The pointer is there now: the entity comes along, as it was held.
  void moveTo(double x, double y);
  /// The entity stays, and turns about the vertical until its x axis points to where the pointer is, seen from above.
  /// Nothing happens while the pointer is near where it took hold, or nearer than 1 cm to the origin.
  void turnTo(double x, double y);

  const geometry_msgs::Pose& pose() const { return pose_; }
  /// Whether it is to be put elsewhere at all: a click moves nothing, though the hand may have trembled.
  bool isMove() const;

 private:
  geometry_msgs::Pose start_;
  geometry_msgs::Pose pose_;
  double grip_x_, grip_y_;
};

}  // namespace swarmanoid
