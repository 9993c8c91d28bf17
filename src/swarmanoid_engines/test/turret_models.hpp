/// Shared by tests of turrets.
#pragma once

#include <memory>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

constexpr double kTurretSpeed = 3.0;  // rad/s, of a footbot

/// A footbot whose turret has another torque [N m].
inline std::shared_ptr<const EntityModel> footbotOfTorque(double torque) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->joints.at(0).max_effort = torque;
  return model;
}

}  // namespace swarmanoid
