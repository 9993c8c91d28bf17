#include "raw_ode.hpp"

namespace swarmanoid::benchmarks {
namespace {

using dynamics3d::OdeLock;
using dynamics3d::setBodyPose;
using dynamics3d::toVector;

// a footbot's, or nearly so
constexpr double kRadius = 0.085;       // m
constexpr double kHeight = 0.1;         // m
constexpr double kClearance = 0.02;     // m
constexpr double kMass = 1.6;           // kg
constexpr double kWheelMass = 0.1;      // kg
constexpr double kCastorRadius = 0.01;  // m
constexpr double kCastorPlace = 0.06;   // m, ahead and behind
constexpr double kTorque = 0.5;         // N m
constexpr double kFriction = 0.9;
constexpr double kWallFriction = 0.5;
constexpr double kSoftness = 1e-6;  // m/s per N: without, the exact solver gives up now and then
constexpr int kMostContacts = 4;    // of two geometries

void* const kSmooth = const_cast<char*>("castor");

}  // namespace

RawOde::RawOde(const Space& space, const std::vector<Row>& robots, double side, Solver solver) : solver_(solver) {
  const OdeLock lock(seed_);
  world_ = dWorldCreate();
  dWorldSetGravity(world_, 0.0, 0.0, -9.81);
  dWorldSetCFM(world_, kSoftness);
  geoms_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
  contacts_ = dJointGroupCreate(0);
  dCreatePlane(geoms_, 0.0, 0.0, 1.0, 0.0);
  addWalls(side);
  for (const Row row : robots) {
    robots_.push_back(makeRobot(space.entities.pose[row], *space.entities.model[row]));
  }
}

RawOde::~RawOde() {
  const OdeLock lock(seed_);
  dJointGroupDestroy(contacts_);
  dSpaceDestroy(geoms_);
  dWorldDestroy(world_);
}

void RawOde::addWalls(double side) {
  constexpr double kThickness = 0.1;  // m
  for (const bool is_upright : {false, true}) {
    for (const double at : {-0.5 * kThickness, side + 0.5 * kThickness}) {
      const double middle = 0.5 * side;
      const dGeomID wall =
          dCreateBox(geoms_, is_upright ? kThickness : side, is_upright ? side : kThickness, 2.0 * kHeight);
      dGeomSetPosition(wall, is_upright ? at : middle, is_upright ? middle : at, kHeight);
    }
  }
}

dGeomID RawOde::addBall(dSpaceID space, const Pose& robot, const Eigen::Vector3d& place, double radius, dBodyID body) {
  const dGeomID ball = dCreateSphere(space, radius);
  dGeomSetBody(ball, body);
  const Eigen::Vector3d centre = robot.toWorld(place);
  dGeomSetOffsetWorldPosition(ball, centre.x(), centre.y(), centre.z());
  return ball;
}

RawOde::Robot RawOde::makeRobot(const Pose& pose, const EntityModel& model) {
  const dSpaceID own = dSimpleSpaceCreate(geoms_);
  const EntityModel::Wheels& wheels = *model.wheels;
  Robot robot;
  robot.chassis = dBodyCreate(world_);
  dMass mass;
  dMassSetCylinderTotal(&mass, kMass, 3, kRadius, kHeight);
  dBodySetMass(robot.chassis, &mass);
  setBodyPose(robot.chassis, pose.toWorld({0.0, 0.0, kClearance + 0.5 * kHeight}), pose.orientation);
  dGeomSetBody(dCreateCylinder(own, kRadius, kHeight), robot.chassis);
  for (const double place : {kCastorPlace, -kCastorPlace}) {
    dGeomSetData(addBall(own, pose, {place, 0.0, kCastorRadius}, kCastorRadius, robot.chassis), kSmooth);
  }
  const Eigen::Vector3d axle = pose.orientation * Eigen::Vector3d::UnitY();
  for (int side = 0; side < 2; ++side) {
    const Eigen::Vector3d place(0.0, (side == 0 ? 0.5 : -0.5) * wheels.separation, wheels.radius);
    const Eigen::Vector3d centre = pose.toWorld(place);
    const dBodyID wheel = dBodyCreate(world_);
    dMassSetSphereTotal(&mass, kWheelMass, wheels.radius);
    dBodySetMass(wheel, &mass);
    setBodyPose(wheel, centre, pose.orientation);
    addBall(own, pose, place, wheels.radius, wheel);
    const dJointID motor = dJointCreateHinge(world_, nullptr);
    dJointAttach(motor, wheel, robot.chassis);
    dJointSetHingeAnchor(motor, centre.x(), centre.y(), centre.z());
    dJointSetHingeAxis(motor, axle.x(), axle.y(), axle.z());
    dJointSetHingeParam(motor, dParamFMax, kTorque);
    robot.motors[side] = motor;
  }
  return robot;
}

void RawOde::setWheelSpeeds(const Space& space, const std::vector<Row>& robots) {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    // the axes point to the left: positive speeds roll ahead
    dJointSetHingeParam(robots_[i].motors[0], dParamVel, space.wheels[robots[i]].left);
    dJointSetHingeParam(robots_[i].motors[1], dParamVel, space.wheels[robots[i]].right);
  }
}

void RawOde::step(double tick, int steps) {
  const OdeLock lock(seed_);
  for (int i = 0; i < steps; ++i) {
    dSpaceCollide(geoms_, this, &RawOde::collide);
    if (solver_ == Solver::kExact) {
      dWorldStep(world_, tick / steps);
    } else {
      dWorldQuickStep(world_, tick / steps);
    }
    dJointGroupEmpty(contacts_);
  }
}

void RawOde::collide(void* self, dGeomID a, dGeomID b) {
  if (dGeomIsSpace(a) != 0 || dGeomIsSpace(b) != 0) {
    dSpaceCollide2(a, b, self, &RawOde::collide);
    return;
  }
  auto& raw = *static_cast<RawOde*>(self);
  const dBodyID body_a = dGeomGetBody(a);
  const dBodyID body_b = dGeomGetBody(b);
  if (body_a == nullptr && body_b == nullptr) {
    return;  // walls and the ground
  }
  dContactGeom found[kMostContacts];
  const int count = dCollide(a, b, kMostContacts, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    dContact contact = {};
    contact.geom = found[i];
    contact.surface.mode = dContactApprox1;
    const bool is_smooth = dGeomGetData(a) == kSmooth || dGeomGetData(b) == kSmooth;
    const bool is_wheel = dGeomGetClass(a) == dSphereClass || dGeomGetClass(b) == dSphereClass;
    contact.surface.mu = is_smooth ? 0.0 : is_wheel ? kFriction : kWallFriction;
    dJointAttach(dJointCreateContact(raw.world_, raw.contacts_, &contact), body_a, body_b);
  }
}

Eigen::Vector3d RawOde::position(std::size_t robot) const { return toVector(dBodyGetPosition(robots_[robot].chassis)); }

}  // namespace swarmanoid::benchmarks
