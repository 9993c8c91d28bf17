// Moves one island: copies bodies from the engine to the solver, and back.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "dynamics2d/dynamics2d.hpp"
#include "dynamics2d/flight.hpp"

namespace swarmanoid::dynamics2d {

int Dynamics2d::placeOf(BodyIndex index) {
  RigidBody& rigid_body = rigid(index);
  const Body& body = bodies_[index];
  if (rigid_body.place >= 0) {
    return rigid_body.place;
  }
  if (rigid_body.shapes.empty()) {
    makeContactShapes(*body.model, rigid_body.arm, rigid_body.shapes);
  }
  SolverBody state;
  state.pose = planar::PlacedPose::at(rigid_body.centre, rigid_body.heading, body.pose);
  if (body.is_movable) {
    state.velocity = rigid_body.velocity;
    state.spin = rigid_body.spin;
    state.inverse_mass = body.role == Role::kMove ? 1.0 / rigid_body.mass : 0.0;
    state.inverse_inertia = body.role == Role::kMove ? 1.0 / rigid_body.inertia : 0.0;
  }
  state.radius = body.model->radius + rigid_body.arm.norm();
  rigid_body.place = island_.add(state, {&rigid_body.shapes, body.along});
  return rigid_body.place;
}

void Dynamics2d::addPair(const Near& near) {
  const Body& other = bodies_[near.second];
  BodyPair pair;
  pair.a = placeOf(near.first);
  pair.b = placeOf(near.second);
  if (static_cast<std::size_t>(pair.b) >= members_.size()) {
    members_.push_back(near.second);
  }
  if (!other.is_movable) {
    pair.kind = BodyPair::Kind::kFixed;
  } else if (other.role == Role::kMirror) {
    pair.kind = BodyPair::Kind::kMirror;
  }
  pair.approach = highestSpeed(near.first) + highestSpeed(near.second);
  island_.pairs.push_back(pair);
}

void Dynamics2d::fillIsland() {
  island_.clear();
  movable_members_ = members_.size();
  for (const BodyIndex index : members_) {
    placeOf(index);
  }
  for (const Near& near : near_of_island_) {
    addPair(near);
  }
  std::sort(island_.pairs.begin(), island_.pairs.end(), [](const BodyPair& a, const BodyPair& b) {
    return std::tie(a.kind, a.a, a.b) < std::tie(b.kind, b.a, b.b);
  });
}

bool Dynamics2d::mayTouch(double tick) const {
  return !island_.grips.empty() || std::any_of(island_.pairs.begin(), island_.pairs.end(), [&](const BodyPair& pair) {
    const double margin = pair.approach * tick + kContactMargin;
    return island_.gapOf(pair, margin) < margin;
  });
}

bool Dynamics2d::hasLoad() const {
  const auto movable_end = members_.begin() + static_cast<std::ptrdiff_t>(movable_members_);
  const auto slides = [&](BodyIndex index) { return !bodies_[index].isDriven(); };
  return !island_.grips.empty() || std::any_of(members_.begin(), movable_end, slides);
}

int Dynamics2d::countPieces(double step) {
  // contacts are solved at the poses of the start of a step, which must not be far from those of its end
  constexpr double kWayAtContact = 0.01;   // m
  constexpr double kTurnAtContact = 0.03;  // rad
  // a robot reaches its speed within some 20 ms, which matters for bodies that it pushes or pulls
  constexpr double kTimeAtContact = 0.05;    // s
  constexpr double kTimeUnderLoad = 0.0125;  // s
  constexpr double kMostWay = 0.03;          // m
  constexpr double kMostTurn = 0.8;          // rad
  constexpr double kMostPieces = 1e4;
  double turn = 0.0;  // rad/s
  island_.highest_speed = 0.0;
  for (const BodyIndex index : members_) {
    turn = std::max(turn, highestRates(index).turn);
    island_.highest_speed = std::max(island_.highest_speed, highestSpeed(index));
  }
  const double speed = island_.highest_speed;
  double rate = std::max(speed / kMostWay, turn / kMostTurn);  // of pieces [1/s]
  if (speed > 0.0 && mayTouch(step * subclock_)) {
    rate =
        std::max({speed / kWayAtContact, turn / kTurnAtContact, 1.0 / (hasLoad() ? kTimeUnderLoad : kTimeAtContact)});
  }
  return static_cast<int>(std::ceil(std::clamp(rate * step - 1e-9, 1.0, kMostPieces)));
}

void Dynamics2d::addConstraints(BodyIndex index, double step) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  if (body.isDriven()) {
    prepareDrive(index, step);
  }
  const Eigen::Vector2d velocity = rigid_body.centre_advance / step;
  if (rigid_body.drive == Drive::kFlight) {
    FlightConstraint flight;
    flight.body = rigid_body.place;
    flight.command = velocity;
    flight.spin = rigid_body.turn_rate;
    flight.most = rigid_body.mass * kFlightAcceleration * step;
    flight.most_turn = rigid_body.inertia * kFlightTurnAcceleration * step;
    island_.flights.push_back(flight);
    return;
  }
  if (rigid_body.drive == Drive::kTreels) {
    TreelConstraint treels;
    treels.body = rigid_body.place;
    treels.treels = &rigid_body.treels;
    treels.command << velocity, rigid_body.turn_rate;
    treels.most = rigid_body.traction * step;
    if (!island_.contactsOfLastTick().empty()) {
      for (std::size_t i = 0; i < treels.impulses.size(); ++i) {
        treels.impulses[i] = bodies_[index].pose.unrotated(rigid_body.treel_forces[i]) * step;
      }
    }
    island_.treels.push_back(treels);
    return;
  }
  SupportConstraint friction;
  friction.body = rigid_body.place;
  friction.support = &supportOf(index);
  friction.most = material_.ground_friction * rigid_body.mass * material_.gravity * step;
  island_.supports.push_back(friction);
}

BodyNumbers Dynamics2d::numbersOf(int place_a, int place_b) const {
  return {bodies_[members_[static_cast<std::size_t>(place_a)]].number,
          bodies_[members_[static_cast<std::size_t>(place_b)]].number};
}

void Dynamics2d::recallContacts(double step) {
  for (std::size_t i = 0; i < island_.pairs.size(); ++i) {
    const BodyPair& pair = island_.pairs[i];
    crowd_memory_.recall(numbersOf(pair.a, pair.b), static_cast<int>(i), step, island_.contactsOfLastTick());
  }
}

void Dynamics2d::keepContacts(double step) {
  for (const ContactConstraint& contact : island_.contacts()) {
    crowd_memory_.keep(numbersOf(contact.a, contact.b), contact, step);
  }
}

const Support& Dynamics2d::supportOf(BodyIndex index) {
  RigidBody& rigid_body = rigid(index);
  if (rigid_body.support.points.empty()) {
    makeSupport(*bodies_[index].model, material_.pressure, rigid_body.support);
  }
  return rigid_body.support;
}

void Dynamics2d::addGrip(BodyIndex index) {
  const Grip& grip = rigid(index).grip;
  if (!grip.isHolding()) {
    return;
  }
  GripConstraint constraint;
  constraint.gripper = rigid(index).place;
  constraint.held = rigid(grip.gripped).place;
  constraint.kind = grip.has_turret ? GripConstraint::Kind::kMotor : GripConstraint::Kind::kRigid;
  constraint.on_gripper = grip.on_gripper;
  constraint.on_held = grip.on_held;
  constraint.angle = grip.angle;
  island_.grips.push_back(constraint);
}

void Dynamics2d::moveIsland(double tick) {
  fillIsland();
  for (std::size_t i = 0; i < movable_members_; ++i) {
    addGrip(members_[i]);
  }
  const int pieces = countPieces(tick / subclock_);
  const double step = tick / (subclock_ * pieces);
  recallContacts(step);
  for (std::size_t i = 0; i < movable_members_; ++i) {
    addConstraints(members_[i], step);
  }
  const IslandRules rules{material_.contact_friction, material_.restitution, material_.iterations};
  for (int i = 0; i < subclock_ * pieces; ++i) {
    driveTurrets(step);
    island_.move(step, rules);
    readGrips(step);
    if ((i + 1) % pieces == 0) {
      tearGrips(pieces * step);
    }
  }
  readIsland(step);
}

void Dynamics2d::readGrips(double step) {
  for (const GripConstraint& grip : island_.grips) {
    Grip& kept = rigid(members_[static_cast<std::size_t>(grip.gripper)]).grip;
    kept.impulse += grip.impulse;
    if (kept.has_turret) {
      readTurret(grip, step);
    }
  }
}

void Dynamics2d::readIsland(double step) {
  readMotions();
  noteForces(step);
  if (island_.isLarge()) {
    keepContacts(step);
  }
  for (const BodyIndex index : members_) {
    rigid(index).place = -1;
  }
}

void Dynamics2d::readMotions() {
  constexpr double kRest = 1e-9;  // m/s, rad/s: friction with the ground leaves that to a body that it stops
  for (std::size_t i = 0; i < movable_members_; ++i) {
    RigidBody& rigid_body = rigid(members_[i]);
    const SolverBody& state = island_.bodies[i];
    rigid_body.centre = state.pose.position;
    rigid_body.heading = state.pose.heading;
    rigid_body.velocity = state.velocity;
    rigid_body.spin = state.spin;
    if (rigid_body.drive == Drive::kNone && std::abs(state.spin) < kRest && state.velocity.norm() < kRest) {
      rigid_body.velocity.setZero();
      rigid_body.spin = 0.0;
    }
  }
}

void Dynamics2d::noteForces(double step) {
  for (const TreelConstraint& treels : island_.treels) {
    const auto place = static_cast<std::size_t>(treels.body);
    std::array<Eigen::Vector2d, 2>& forces = rigid(members_[place]).treel_forces;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      forces[i] = island_.bodies[place].pose.rotated(treels.impulses[i]) / step;
    }
  }
  for (const FlightConstraint& flight : island_.flights) {
    rigid(members_[static_cast<std::size_t>(flight.body)]).last_push = flight.impulse / step;
  }
  for (const ContactConstraint& contact : island_.contacts()) {
    for (int i = 0; i < contact.patch.count; ++i) {
      const ContactConstraint::Point& point = contact.points[static_cast<std::size_t>(i)];
      if (point.impulse > 0.0) {
        const auto a = static_cast<std::size_t>(contact.a);
        contacts_.push_back({members_[a], island_.bodies[a].pose.position + point.arm_a, -contact.normal});
      }
    }
  }
}

}  // namespace swarmanoid::dynamics2d
