/// A small world for tests and benchmarks: a space with one planar engine, no devices, no experiment file.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "carry_out.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// A footbot as in figure 3.9: a body, two wheels, a square gripper. Radius 0.085 m, gripper's tip at 0.11 m.
inline std::shared_ptr<const EntityModel> footbotModel() {
  static const auto model = [] {
    auto footbot = std::make_shared<EntityModel>();
    footbot->type = "footbot";
    footbot->is_robot = true;
    footbot->is_movable = true;
    const auto cylinder = [&](double radius, double length, const Eigen::Vector3d& position) {
      footbot->shapes.push_back(
          {CollisionShape::Kind::kCylinder, {radius, radius, length / 2.0}, position, Eigen::Quaterniond::Identity()});
    };
    cylinder(0.085, 0.136, {0.0, 0.0, 0.078});
    cylinder(0.018, 0.058, {0.0, 0.07, 0.029});
    cylinder(0.018, 0.058, {0.0, -0.07, 0.029});
    footbot->shapes.push_back(
        {CollisionShape::Kind::kBox, {0.02, 0.02, 0.015}, {0.09, 0.0, 0.05}, Eigen::Quaterniond::Identity()});
    footbot->gripping_radius = 0.085;
    footbot->wheels = EntityModel::Wheels{0.029, 0.14, 10.344827586206895, "left_wheel", "right_wheel"};
    footbot->gripper = EntityModel::Gripper{0.11, 0.05};
    footbot->holders.push_back({"gripper", EntityModel::Holder::Kind::kGripper, "gripper_tip", 0.0});
    footbot->measureShapes();
    footbot->addMass({1.8, {0.0, 0.0, 0.065}, Eigen::Vector3d(0.004, 0.004, 0.0055).asDiagonal().toDenseMatrix()});
    return footbot;
  }();
  return model;
}

/// A robot with a footbot's wheels whose body is one cylinder.
inline std::shared_ptr<const EntityModel> discModel(double radius, double height) {
  auto disc = std::make_shared<EntityModel>(*cylindricPreyModel(radius, height));
  disc->type = "disc";
  disc->is_robot = true;
  disc->gripping_radius.reset();
  disc->wheels = footbotModel()->wheels;
  return disc;
}

/// A pose in the plane z = 0.
inline Pose flatPose(double x, double y, double heading = 0.0, double z = 0.0) {
  return {{x, y, z}, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))};
}

inline double headingOf(const Pose& pose) { return 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()); }

template <class TestedEngine>
class PlanarWorld {
 public:
  explicit PlanarWorld(const Eigen::Vector3d& size = {10.0, 10.0, 2.0}, int subclock = 1, const std::string& axis = "z",
                       double distance = 0.0, const std::map<std::string, std::string>& parameters = {}) {
    space.size = size;
    Configuration configuration("engine", "", {});
    configuration.set("subclock", std::to_string(subclock));
    configuration.set("perpendicular_axis", axis);
    configuration.set("distance", std::to_string(distance));
    for (const auto& [name, value] : parameters) {
      configuration.set(name, value);
    }
    engine.configure("ground", configuration);
    space.engines.push_back(&engine);
  }

  /// Adds an entity to the space only.
  Row addToSpace(const std::shared_ptr<const EntityModel>& model, const Pose& pose) {
    const Row row = space.entities.add("e" + std::to_string(++count_), model, pose, colors::kBlack);
    space.mover[row] = nullptr;
    return row;
  }
  Row add(const std::shared_ptr<const EntityModel>& model, const Pose& pose, Role role = Role::kMove) {
    const Row row = addToSpace(model, pose);
    engine.add(space, row, role);
    if (role == Role::kMove) {
      space.mover[row] = &engine;
    }
    return row;
  }
  /// A robot with commands for its wheels and its gripper, and with additional devices.
  template <class... Devices>
  Row addRobot(const std::shared_ptr<const EntityModel>& model, const Pose& pose) {
    const Row row = addToSpace(model, pose);
    (space.actuation.bank<Devices>().add(row), ...);
    space.actuation.bank<FootbotWheels>().add(row);
    space.actuation.bank<FootbotGripper>().add(row);
    test::carryOut(space, row);
    engine.add(space, row, Role::kMove);
    space.mover[row] = &engine;
    return row;
  }
  Row addFootbot(const Pose& pose) { return addRobot(footbotModel(), pose); }
  /// A robot with commands for its wheels, its gripper and its turret.
  Row addTurret(const Pose& pose, const std::shared_ptr<const EntityModel>& model = robotModel("footbot")) {
    return addRobot<FootbotTurret>(model, pose);
  }
  FootbotTurret& turret(Row row) { return *space.actuation.bank<FootbotTurret>().find(row); }
  const JointState& turretState(Row row) const { return space.joints[row][0]; }
  Row addBlock(const Eigen::Vector3d& size, const Eigen::Vector3d& centre, double heading = 0.0) {
    return add(blockModel(size), flatPose(centre.x(), centre.y(), heading, centre.z()));
  }
  Row addPrey(double radius, double height, double x, double y, double mass = kPreyMass) {
    return add(cylindricPreyModel(radius, height, mass), flatPose(x, y));
  }
  void remove(Row row) {
    space.structure.isolate(row);
    space.actuation.bank<FootbotWheels>().remove(row);
    space.actuation.bank<FootbotGripper>().remove(row);
    space.actuation.bank<FootbotTurret>().remove(row);
    engine.remove(space, row);
    space.mover[row] = nullptr;
    space.entities.remove(row);
  }

  /// Sets the wheel speeds for a velocity of a footbot. @param speed [m/s]; @param turn_rate [rad/s]
  void drive(Row row, double speed, double turn_rate = 0.0) {
    const EntityModel::Wheels& geometry = *footbotModel()->wheels;
    const double difference = 0.5 * turn_rate * geometry.separation;
    space.actuation.bank<FootbotWheels>().find(row)->setAngularVelocity((speed - difference) / geometry.radius,
                                                                        (speed + difference) / geometry.radius);
  }
  void setGripper(Row row, bool closed) { space.actuation.bank<FootbotGripper>().find(row)->closed = closed; }

  /// Runs ticks of 0.1 s.
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      space.events.clear();
      test::carryOut(space);
      engine.readMirrors(space);
      engine.move(space, MoveAccess(space), std::chrono::milliseconds(100));
      engine.connect(space, ConnectAccess(space));
    }
  }

  const Pose& pose(Row row) const { return space.entities.pose[row]; }
  Pose& pose(Row row) { return space.entities.pose[row]; }
  const Twist& twist(Row row) const { return space.entities.twist[row]; }

  RayHit castRay(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Row ignored = kNoRow) const {
    return space.castRay({from, to}, ignored);
  }

  Space space;
  TestedEngine engine;

 private:
  int count_ = 0;
};

}  // namespace swarmanoid
