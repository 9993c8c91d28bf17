/// A world with a handbot under a ceiling.
#pragma once

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {

constexpr double kCeiling = 2.5;  // m: its lower face

// Holders of the robots' models, by their indices there.
constexpr std::size_t kLeftHand = 0;
constexpr std::size_t kRightHand = 1;
constexpr std::size_t kRope = 2;
constexpr std::size_t kMagnet = 0;  // of an eyebot

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
  const Attachment& held(Row row, std::size_t holder) const { return space.attachments.of(row, holder); }
  double angle(Row row, const std::string& joint) const { return space.joints[row][indexOf(joint)].angle; }
  double effort(Row row, const std::string& joint) const { return space.joints[row][indexOf(joint)].effort; }
  static int indexOf(const std::string& joint) { return robotModel("handbot")->findJoint(joint); }

  Row ceiling = kNoRow;
};

}  // namespace swarmanoid::dynamics3d
