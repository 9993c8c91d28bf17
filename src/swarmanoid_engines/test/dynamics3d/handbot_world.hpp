/// A world with a handbot under a ceiling.
#pragma once

#include "world.hpp"

namespace swarmanoid::dynamics3d {

constexpr double kCeiling = 2.5;  // m: its lower face

class HandbotWorld : public World {
 public:
  explicit HandbotWorld(Values values = {}, bool is_ferromagnetic = true) : World(values) {
    ceiling = add(blockModel({5.0, 5.0, 0.1}, 0.0, is_ferromagnetic), flatPose(2.5, 2.5, 0.0, kCeiling + 0.05));
  }

  Row addHandbot(const Pose& pose, Role role = Role::kMove) {
    return addRobot<HandbotArms, HandbotHands, HandbotRope>(robotModel("handbot"), pose, role);
  }
  HandbotArms& arms(Row row) { return *space.actuation.bank<HandbotArms>().find(row); }
  HandbotHands& hands(Row row) { return *space.actuation.bank<HandbotHands>().find(row); }
  HandbotRope& rope(Row row) { return *space.actuation.bank<HandbotRope>().find(row); }
  const Attachment& held(Row row, Attachment::Kind kind) const { return space.attachments.of(row, kind); }
  double angle(Row row, const std::string& joint) const { return space.jointsOf(row)[indexOf(joint)].angle; }
  double effort(Row row, const std::string& joint) const { return space.jointsOf(row)[indexOf(joint)].effort; }
  static int indexOf(const std::string& joint) { return robotModel("handbot")->findJoint(joint); }

  Row ceiling = kNoRow;
};

}  // namespace swarmanoid::dynamics3d
