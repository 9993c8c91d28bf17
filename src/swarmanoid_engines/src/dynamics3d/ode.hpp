/// The Open Dynamics Engine library in this engine: started once per process, used by one world at a time.
///
/// ODE has state of the whole process (a random seed, default threading, counts of its users). Each caller holds an
/// OdeLock, which excludes other callers, restores the world's own random seed, and saves it on release. So the worlds
/// of one process neither disturb each other nor depend on their order. ODE makes no threads here.
#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <mutex>
#include <type_traits>

namespace swarmanoid::dynamics3d {

static_assert(std::is_same_v<dReal, double>, "ODE must be built in double precision");

/// Exclusive use of ODE in this process, with the random seed of one world.
class OdeLock {
 public:
  /// Waits until no other thread uses ODE. @param seed the world's; kept up to date
  explicit OdeLock(unsigned long& seed);
  ~OdeLock();
  OdeLock(const OdeLock&) = delete;
  OdeLock& operator=(const OdeLock&) = delete;

  /// Whether this thread holds an OdeLock.
  static bool isHeld();

 private:
  std::unique_lock<std::mutex> lock_;
  unsigned long& seed_;
};

/// Number of failures of the exact solver in this process, which ODE only prints. @pre an OdeLock is held
long solverFailures();

inline Eigen::Vector3d toVector(const dReal* v) { return {v[0], v[1], v[2]}; }
inline Eigen::Quaterniond toQuaternion(const dReal* q) { return {q[0], q[1], q[2], q[3]}; }

/// Velocity of a point of a body, in W [m/s]. @param rigid null: does not move @param point in W
inline Eigen::Vector3d velocityAt(dBodyID rigid, const Eigen::Vector3d& point) {
  dVector3 velocity = {};
  if (rigid != nullptr) {
    dBodyGetPointVel(rigid, point.x(), point.y(), point.z(), velocity);
  }
  return toVector(velocity);
}

/// Sets the pose of a body's centre of mass.
inline void setBodyPose(dBodyID rigid, const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  const dQuaternion q = {orientation.w(), orientation.x(), orientation.y(), orientation.z()};
  dBodySetPosition(rigid, position.x(), position.y(), position.z());
  dBodySetQuaternion(rigid, q);
}
/// Sets the pose of a solid without a body.
inline void setGeomPose(dGeomID geom, const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  const dQuaternion q = {orientation.w(), orientation.x(), orientation.y(), orientation.z()};
  dGeomSetPosition(geom, position.x(), position.y(), position.z());
  dGeomSetQuaternion(geom, q);
}
/// Sets the pose of a solid relative to the centre of mass of its body.
inline void setGeomOffset(dGeomID geom, const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  const dQuaternion q = {orientation.w(), orientation.x(), orientation.y(), orientation.z()};
  dGeomSetOffsetPosition(geom, position.x(), position.y(), position.z());
  dGeomSetOffsetQuaternion(geom, q);
}

}  // namespace swarmanoid::dynamics3d
