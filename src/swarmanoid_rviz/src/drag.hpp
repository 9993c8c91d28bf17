/// Where an entity is put that is dragged over the horizontal plane in which its origin lies. No Ogre and no Qt here.
///
/// Frames  world; lengths in m.
#pragma once

#include <geometry_msgs/Pose.h>

namespace swarmanoid {

class Drag {
 public:
  /// The pointer took hold of the entity at this point of the plane.
  Drag(const geometry_msgs::Pose& pose, double x, double y) : start_(pose), grip_x_(x), grip_y_(y), x_(x), y_(y) {}

  /// The height of the plane.
  double height() const { return start_.position.z; }

  /// The pointer is there now.
  /// @param turns false: the entity comes along, as it was held; true: it stays, and turns about the vertical until its
  /// x axis points there, seen from above, unless that is nearer than 1 cm to its origin
  void follow(double x, double y, bool turns) {
    x_ = x;
    y_ = y;
    turns_ = turns;
  }

  /// Whether it is to be put elsewhere at all: a click moves nothing, though the hand may have trembled.
  bool isMove() const;

  /// Where it is to be put. @param now where it is meanwhile: of that stays what is not dragged
  geometry_msgs::Pose applyTo(const geometry_msgs::Pose& now) const;
  /// The same if it has not moved since.
  geometry_msgs::Pose pose() const { return applyTo(start_); }

 private:
  geometry_msgs::Pose start_;
  double grip_x_, grip_y_;
  double x_, y_;
  bool turns_ = false;
};

}  // namespace swarmanoid
