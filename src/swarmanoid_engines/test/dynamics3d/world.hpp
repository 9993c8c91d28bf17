/// A small world for tests and benchmarks: a space with one dynamic engine, no devices, no experiment file.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

#include "../carry_out.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/access.hpp"

namespace swarmanoid::dynamics3d {

constexpr double kGravity = 9.81;  // m/s2
constexpr double kDegree = M_PI / 180.0;

/// A pose on the ground.
inline Pose flatPose(double x, double y, double heading = 0.0, double z = 0.0) {
  return {{x, y, z}, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))};
}

/// Heading about z, of bodies that may be tilted [rad].
inline double headingOf(const Pose& pose) {
  const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

/// Angle of the body's z axis from the vertical [rad].
inline double tiltOf(const Pose& pose) {
  const Eigen::Vector3d up = pose.orientation * Eigen::Vector3d::UnitZ();
  return std::atan2(std::hypot(up.x(), up.y()), up.z());
}

class World {
 public:
  using Values = std::initializer_list<std::pair<std::string, std::string>>;

  explicit World(Values values = {}) {
    space.size = {10.0, 10.0, 2.0};
    space.clocktick = std::chrono::milliseconds(100);
    Configuration configuration("dynamics3d", "", {});
    for (const auto& [name, value] : values) {
      configuration.set(name, value);
    }
    engine.configure("ground", configuration);
    space.engines.push_back(&engine);
  }

  /// Must be called before entities are added.
  void setTerrain(std::shared_ptr<const Terrain> terrain) {
    space.terrain = std::move(terrain);
    engine.prepare({space.terrain, nullptr});
  }

  Row addToSpace(const std::shared_ptr<const EntityModel>& model, const Pose& pose) {
    const Row row = space.entities.add("e" + std::to_string(++count_), model, pose, colors::kBlack);
    space.mover[row] = nullptr;
    return row;
  }
  Row add(const std::shared_ptr<const EntityModel>& model, const Pose& pose, Role role = Role::kMove) {
    return addRobot<>(model, pose, role);
  }
  /// A robot with actuators.
  template <class... Devices>
  Row addRobot(const std::shared_ptr<const EntityModel>& model, const Pose& pose, Role role = Role::kMove) {
    const Row row = addToSpace(model, pose);
    (space.actuation.bank<Devices>().add(row), ...);
    test::carryOut(space, row);
    engine.add(space, row, role);
    if (role == Role::kMove) {
      space.mover[row] = &engine;
    }
    return row;
  }
  Row addFootbot(const Pose& pose) { return addRobot<FootbotWheels, FootbotGripper>(robotModel("footbot"), pose); }
  Row addTurret(const Pose& pose, const std::shared_ptr<const EntityModel>& model = robotModel("footbot")) {
    return addRobot<FootbotWheels, FootbotGripper, FootbotTurret>(model, pose);
  }
  Row addEyebot(const Pose& pose) { return addRobot<EyebotVelocity>(robotModel("eyebot"), pose); }
  FootbotTurret& turret(Row row) { return *space.actuation.bank<FootbotTurret>().find(row); }
  const JointState& turretState(Row row) const { return space.joints[row][0]; }
  Row addBlock(const Eigen::Vector3d& size, double mass, const Pose& pose) { return add(blockModel(size, mass), pose); }
  Row addPrey(double radius, double height, double mass, double x, double y) {
    return add(cylindricPreyModel(radius, height, mass), flatPose(x, y));
  }
  void remove(Row row) {
    space.structure.isolate(row);
    space.attachments.isolate(row);
    engine.remove(space, row);
    space.mover[row] = nullptr;
    space.entities.remove(row);
  }

  /// Wheel speeds from the velocity of a footbot. @param speed [m/s]; @param turn_rate [rad/s]
  void drive(Row row, double speed, double turn_rate = 0.0) {
    const EntityModel::Wheels& geometry = *robotModel("footbot")->wheels;
    const double difference = 0.5 * turn_rate * geometry.separation;
    space.actuation.bank<FootbotWheels>().find(row)->setAngularVelocity((speed - difference) / geometry.radius,
                                                                        (speed + difference) / geometry.radius);
  }
  /// Moves an entity from outside.
  void place(Row row, const Pose& pose) {
    space.structure.isolate(row);
    space.attachments.isolate(row);
    this->pose(row) = pose;
    twist(row) = Twist{};
    engine.place(space, row);
  }
  void setGripper(Row row, bool closed) { space.actuation.bank<FootbotGripper>().find(row)->closed = closed; }
  EyebotVelocity& flight(Row row) { return *space.actuation.bank<EyebotVelocity>().find(row); }

  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      space.events.clear();
      test::carryOut(space);
      engine.readMirrors(space);
      engine.move(space, MoveAccess(space), space.clocktick);
      engine.connect(space, ConnectAccess(space));
      ++space.tick;
    }
  }

  const Pose& pose(Row row) const { return space.entities.pose[row]; }
  Pose& pose(Row row) { return space.entities.pose[row]; }
  const Twist& twist(Row row) const { return space.entities.twist[row]; }
  Twist& twist(Row row) { return space.entities.twist[row]; }
  Row gripped(Row row) const { return space.structure.grippedBy(row); }

  RayHit castRay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Row ignored = kNoRow) const {
    return space.castRay({from, to}, ignored);
  }

  Space space;
  Dynamics3d engine;

 private:
  int count_ = 0;
};

}  // namespace swarmanoid::dynamics3d
