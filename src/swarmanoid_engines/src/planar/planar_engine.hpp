/// Base of the engines that work in a plane (thesis 3.5.1, figure 3.8): the plane, its bodies, the poses that are
/// allowed, and rays.
#pragma once

#include <vector>

#include "planar/bodies.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/engine.hpp"

namespace swarmanoid::planar {

class PlanarEngine : public Engine {
 public:
  void configure(const std::string& id, const Configuration& parameters) override;
  std::string unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const override;
  /// True for arms, hands, ropes and magnets.
  bool mayStandIdle(const EntityModel& model, const DeviceUse& device) const override;
  std::string unsupportedStateReason(const Space& space, Row row) const override;
  /// Rejects movable entities outside the plane, and wheeled robots that do not stand on their treels, which then could
  /// not drive along the plane.
  std::string invalidPoseReason(const EntityModel& model, const Pose& pose) const override;
  using Engine::overlap;
  Row overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const override;
  bool mayHit(const RayBundle& rays) const override;
  void findObstacles(const RayBundle& rays, Obstacles& found) const override;
  void raycast(const RayBundle& rays, Span<RayHit> hits) const override;
  void castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const override;
  bool blocks(Row row, const RayBundle& ray) const override;
  /// True if the plane is vertical.
  bool hitsPrisms() const override;
  void draw(EngineDrawing& drawing) const override;
  EngineHealth health() const override { return {subclock_, "", {}}; }

 protected:
  /// The parameters subclock, perpendicular_axis and distance.
  static std::vector<Parameter> placementParameters();

  /// Converts the command of wheels or flight to `velocity` and `turn_rate`. @pre the body has one of them
  static void readCommands(const Space& space, Body& body);

  /// Wheels turn at the commanded speed even if the robot is blocked; then they slip. @param tick [s]
  static void turnWheels(const Space& space, const MoveAccess& access, const Body& body, double tick);

  /// Writes the pose of a body that has moved in this tick. A body that did not turn keeps its orientation bit for bit.
  void writePose(const MoveAccess& access, BodyIndex index, double heading_before) const;

  Bodies bodies_;
  int subclock_ = 1;
};

// Inline because engines call these functions for each body in each tick.

inline void PlanarEngine::readCommands(const Space& space, Body& body) {
  SWARMANOID_EXPECTS(body.isDriven());
  const PlanarModel& model = *body.model;
  if (body.is_wheeled) {
    const EntityModel::Wheels& geometry = *body.entity->wheels;
    const WheelsCommand& wheels = space.wheels[body.row];
    body.velocity = 0.5 * (wheels.left + wheels.right) * geometry.radius * model.ahead;
    body.turn_rate = (wheels.right - wheels.left) * geometry.radius / geometry.separation * model.turn;
  } else {
    const FlightCommand& flight = space.flight[body.row];
    const Eigen::Vector3d& linear = flight.linear;
    body.velocity = linear.x() * model.ahead + linear.y() * model.left + linear.z() * model.up;
    body.turn_rate = flight.yaw_rate * model.turn;
  }
}

inline void PlanarEngine::turnWheels(const Space& space, const MoveAccess& access, const Body& body, double tick) {
  if (body.is_wheeled) {
    const WheelsCommand& speeds = space.wheels[body.row];
    WheelTurns& turns = access.wheel_turns[body.row];
    turns.left += speeds.left * tick;
    turns.right += speeds.right * tick;
  }
}

inline void PlanarEngine::writePose(const MoveAccess& access, BodyIndex index, double heading_before) const {
  const Body& body = bodies_[index];
  Pose& pose = access.pose[body.row];
  pose.position = bodies_.plane().toGlobal(body.pose.position, body.along);
  if (body.pose.heading != heading_before) {
    pose.orientation = bodies_.plane().orientation(body.pose.heading, bodies_.details(index).base);
  }
}

}  // namespace swarmanoid::planar
