/// ODE alone, in its leanest use for a swarm of differential drives: the reference for the engine based on it.
///
/// A robot is a cylinder on two wheels with motors, which are balls on hinges, and on two castors, which are balls
/// without friction. Robots stand on a plane between four walls, created at their places. ODE's own spaces find
/// contacts: a sweep-and-prune space of one simple space for each robot.
#pragma once

#include <memory>
#include <vector>

#include "dynamics3d/ode.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::benchmarks {

class RawOde {
 public:
  enum class Solver { kExact, kQuick };  ///< dWorldStep, dWorldQuickStep

  /// Makes a robot for each of these entities. @param side of the square arena [m]
  RawOde(const Space& space, const std::vector<Row>& robots, double side, Solver solver);
  ~RawOde();
  RawOde(const RawOde&) = delete;
  RawOde& operator=(const RawOde&) = delete;

  /// Sets the motors of every robot to the commanded wheel speeds in the space.
  void setWheelSpeeds(const Space& space, const std::vector<Row>& robots);

  /// @param tick [s]
  void step(double tick, int steps);

  /// Position of a robot, given by its index in the constructor's list [m].
  Eigen::Vector3d position(std::size_t robot) const;

 private:
  struct Robot {
    dBodyID chassis = nullptr;
    dJointID motors[2] = {nullptr, nullptr};  // left, right
  };

  static void collide(void* self, dGeomID a, dGeomID b);
  void addWalls(double side);
  Robot makeRobot(const Pose& pose, const EntityModel& model);
  /// A ball at a place in the robot's frame.
  dGeomID addBall(dSpaceID space, const Pose& robot, const Eigen::Vector3d& place, double radius, dBodyID body);

  Solver solver_;
  unsigned long seed_ = 0;
  dWorldID world_ = nullptr;
  dSpaceID geoms_ = nullptr;
  dJointGroupID contacts_ = nullptr;
  std::vector<Robot> robots_;
};

}  // namespace swarmanoid::benchmarks
