// Turrets of bodies, and shapes that joints turn.
#include <algorithm>
#include <utility>

#include "planar/bodies.hpp"

namespace swarmanoid::planar {

void Bodies::findTurret(const Space& space, BodyIndex index) {
  const Body& body = (*this)[index];
  const Eigen::Quaterniond& base = details(index).base;
  const int joint = body.entity->joints.empty() ? -1 : turretJoint(*body.entity);
  const bool is_commanded =
      joint >= 0 && space.joint_commands[body.row][static_cast<std::size_t>(joint)].mode != JointCommand::Mode::kNone;
  if (!is_commanded || body.role == Role::kMirror || !plane_.isUpright(base)) {
    return;
  }
  Turret turret;
  turret.body = index;
  turret.joint = joint;
  turret.sense = body.model->turn > 0.0 ? 1.0 : -1.0;
  turret.state = space.joints[body.row][joint];
  turrets_.insert(std::upper_bound(turrets_.begin(), turrets_.end(), turret,
                                   [&](const Turret& a, const Turret& b) {
                                     return (*this)[a.body].number < (*this)[b.body].number;
                                   }),
                  turret);
}

void Bodies::readTurretCommands(const Space& space) {
  for (Turret& turret : turrets_) {
    turret.command = space.joint_commands[(*this)[turret.body].row][static_cast<std::size_t>(turret.joint)];
  }
}

const Turret* Bodies::findTurret(BodyIndex index) const {
  const EntityNumber number = (*this)[index].number;
  const auto found =
      std::lower_bound(turrets_.begin(), turrets_.end(), number,
                       [&](const Turret& turret, EntityNumber wanted) { return (*this)[turret.body].number < wanted; });
  return found != turrets_.end() && found->body == index ? &*found : nullptr;
}

Turret* Bodies::findTurret(BodyIndex index) { return const_cast<Turret*>(std::as_const(*this).findTurret(index)); }

const PlanarModel& Bodies::modelAt(const Turret& turret, double angle) {
  const BodyDetails& record = details(turret.body);
  if (record.own) {
    tried_.joints = record.own->joints;
  } else {
    tried_.joints.assign(record.entity->joints.size(), JointState{});
  }
  tried_.joints[static_cast<std::size_t>(turret.joint)].angle = angle;
  projectModel(*record.entity, plane_, record.base, tried_.model, tried_.joints);
  return tried_.model;
}

void Bodies::turnShapes(const Turret& turret, double angle) {
  ownProjection(turret.body).joints[static_cast<std::size_t>(turret.joint)].angle = angle;
  takeProjection(turret.body);
}

double Bodies::shapesAngle(const Turret& turret) const {
  const auto& own = details(turret.body).own;
  return own ? own->joints[static_cast<std::size_t>(turret.joint)].angle : 0.0;
}

OwnProjection& Bodies::ownProjection(BodyIndex index) {
  BodyDetails& record = details(index);
  if (!record.own) {
    record.own = std::make_unique<OwnProjection>();
    record.own->joints.resize(record.entity->joints.size());
  }
  return *record.own;
}

void Bodies::takeProjection(BodyIndex index) {
  Body& body = (*this)[index];
  const BodyDetails& record = details(index);
  projectModel(*record.entity, plane_, record.base, record.own->model, record.own->joints);
  body.model = &record.own->model;
  circles_[static_cast<std::size_t>(index)].radius = body.model->radius;
  largest_radius_ = std::max(largest_radius_, body.is_large ? 0.0 : body.model->radius);
}

bool Bodies::haveJointsTurned(const Space& space, BodyIndex index) const {
  const BodyDetails& record = details(index);
  const Span<const JointState> now = space.joints[(*this)[index].row];
  for (std::size_t i = 0; i < record.entity->joints.size(); ++i) {
    if (now[i].angle != (record.own ? record.own->joints[i].angle : 0.0)) {
      return true;
    }
  }
  return false;
}

}  // namespace swarmanoid::planar
