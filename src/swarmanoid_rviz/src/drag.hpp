/// Target pose of an entity that the pointer drags over the horizontal plane through its origin. Free of Ogre and Qt.
///
/// Frames  world; lengths in m.
#pragma once

#include <geometry_msgs/Pose.h>

namespace swarmanoid {

class Drag {
 public:
  /// @param pose of the entity @param x, y point of the plane at which the pointer grips the entity
  Drag(const geometry_msgs::Pose& pose, double x, double y) : start_(pose), grip_x_(x), grip_y_(y), x_(x), y_(y) {}

  /// Height of the plane [m].
  double height() const { return start_.position.z; }

  /// Sets the current point of the pointer.
  /// @param turns false: the entity moves along with the pointer; true: it stays, and turns about the vertical until
  /// its x axis points to the pointer, seen from above, unless the pointer is less than 1 cm from its origin
  void follow(double x, double y, bool turns) {
    x_ = x;
    y_ = y;
    turns_ = turns;
  }

  /// Whether the drag exceeds the tolerance for clicks: 1 cm, and for turns also 0.02 rad.
  bool isMove() const;

  /// Target pose. @param now current pose; the components that the drag does not change are taken from it
  geometry_msgs::Pose applyTo(const geometry_msgs::Pose& now) const;
  /// Target pose if the entity has not moved since the drag began.
  geometry_msgs::Pose pose() const { return applyTo(start_); }

 private:
  geometry_msgs::Pose start_;
  double grip_x_, grip_y_;
  double x_, y_;
  bool turns_ = false;
};

}  // namespace swarmanoid
