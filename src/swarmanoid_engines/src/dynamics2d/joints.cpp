#include "dynamics2d/joints.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "dynamics2d/friction.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics2d {
namespace {

Eigen::Vector2d toDouble(const b2Vec2& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }
b2Vec2 toFloat(const Eigen::Vector2d& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

}  // namespace

void TreelJoint::SolveVelocityConstraints(const b2SolverData& data) {
  SWARMANOID_EXPECTS(m_invMassA == 0.0F && m_invIA == 0.0F);
  const b2Velocity& belt = data.velocities[m_indexA];
  b2Velocity& robot = data.velocities[m_indexB];
  const b2Vec2 slip = robot.v + b2Cross(robot.w, m_rB) - belt.v - b2Cross(belt.w, m_rA);
  const Eigen::Vector2d across = toDouble(b2Cross(1.0F, m_rB));
  const double inverse_mass = m_invMassB;
  const double inverse_inertia = m_invIB;
  const Eigen::Matrix2d yield =
      inverse_mass * Eigen::Matrix2d::Identity() + inverse_inertia * across * across.transpose();
  const Eigen::Vector2d before = toDouble(m_linearImpulse);
  const double most = static_cast<double>(data.step.dt) * static_cast<double>(m_maxForce);
  const double size = before.squaredNorm();
  const double guess = size > 0.99 * most * most ? -before.dot(toDouble(slip)) / size : 0.0;
  const Eigen::Vector2d impulse = coulombFriction(yield, toDouble(slip) - yield * before, most, guess);
  const b2Vec2 added = toFloat(impulse - before);
  m_linearImpulse = toFloat(impulse);
  robot.v += m_invMassB * added;
  robot.w += m_invIB * b2Cross(m_rB, added);
}

void TurretJoint::SolveVelocityConstraints(const b2SolverData& data) {
  if (!m_enableMotor) {
    b2RevoluteJoint::SolveVelocityConstraints(data);
    return;
  }
  b2Velocity& robot = data.velocities[m_indexA];
  b2Velocity& load = data.velocities[m_indexB];
  const b2Vec2 apart = load.v + b2Cross(load.w, m_rB) - robot.v - b2Cross(robot.w, m_rA);
  // what the velocities of the pivot and of the motor change by for each unit of impulse at the pivot, and in the motor
  Eigen::Matrix3d yield;
  yield << static_cast<double>(m_K.ex.x), static_cast<double>(m_K.ey.x), -m_rA.y * m_invIA - m_rB.y * m_invIB,
      static_cast<double>(m_K.ex.y), static_cast<double>(m_K.ey.y), m_rA.x * m_invIA + m_rB.x * m_invIB,  //
      -m_rA.y * m_invIA - m_rB.y * m_invIB, m_rA.x * m_invIA + m_rB.x * m_invIB, m_invIA + m_invIB;
  const Eigen::Vector3d wrong(apart.x, apart.y, load.w - robot.w - m_motorSpeed);
  const double wanted = -(yield.inverse() * wrong).z();
  const double most = static_cast<double>(data.step.dt) * static_cast<double>(m_maxMotorTorque);
  const double before = m_motorImpulse;
  const double turned = std::clamp(before + wanted, -most, most) - before;
  const Eigen::Vector2d pulled =
      -(yield.topLeftCorner<2, 2>().inverse() * (wrong.head<2>() + turned * yield.topRightCorner<2, 1>()));
  const b2Vec2 pull = toFloat(pulled);
  const auto turn = static_cast<float>(turned);
  m_motorImpulse = static_cast<float>(before + turned);
  m_impulse += pull;
  robot.v -= m_invMassA * pull;
  robot.w -= m_invIA * (b2Cross(m_rA, pull) + turn);
  load.v += m_invMassB * pull;
  load.w += m_invIB * (b2Cross(m_rB, pull) + turn);
}

}  // namespace swarmanoid::dynamics2d
