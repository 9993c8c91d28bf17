// Bodies that nothing can reach in a tick are moved without Box2D, whose work would all be for finding contacts that
// cannot be there. In a swarm that is nearly everybody, so what is near can be moved in as fine steps as it needs.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {
namespace {
constexpr double kClose = 1e-3;    // m: contacts begin before surfaces touch
constexpr double kFastWay = 0.14;  // m in a tick: for so few, others need not look around each time
}  // namespace

void Dynamics2d::measureWay(BodyIndex index, double tick, double jump) {
  const Body& body = bodies_[index];
  RigidBody& its = rigid(index);
  // as fast as it is now or is told to be; and who is hit may be twice as fast as who hits it
  const double turn = std::max(std::abs(its.spinNow()), std::abs(body.turn_rate));
  const double speed = std::sqrt(std::max(its.velocityNow().squaredNorm(), body.velocity.squaredNorm()));
  its.way = 2.0 * (speed + turn * its.arm.norm()) * tick + jump + kClose;
  its.is_reached = false;
  const bool was_fast = its.is_fast;
  its.is_fast = its.way > kFastWay;
  if (was_fast && !its.is_fast) {
    travelled_ += kLookAhead;  // those who have looked around since then have not minded it
  }
  longest_way_ = std::max(longest_way_, its.way);
  if (!its.is_fast) {
    longest_slow_way_ = std::max(longest_slow_way_, its.way);
  }
}

void Dynamics2d::sortOut() {
  for (const std::vector<BodyIndex>* list : {&movers_, &mirrors_}) {
    for (const BodyIndex index : *list) {
      if (rigid(index).is_fast) {
        warnOthers(index);
      }
    }
  }
  present_.clear();
  for (const BodyIndex index : movers_) {
    RigidBody& its = rigid(index);
    bool may_leave = !its.is_reached && its.isFree() && (its.drive != Drive::kNone || its.isAtRest());
    if (may_leave && !its.is_fast) {
      if (travelled_ + longest_slow_way_ > its.free_until) {
        lookAround(index);
      }
      may_leave = travelled_ + longest_slow_way_ <= its.free_until;
    }
    if (may_leave) {
      leaveBox2d(index);
    } else {
      enterBox2d(index);
      present_.push_back(index);
    }
  }
  travelled_ += longest_slow_way_;
}

void Dynamics2d::warnOthers(BodyIndex index) {
  const Body& body = bodies_[index];
  RigidBody& its = rigid(index);
  const Eigen::Vector2d& centre = body.pose.position;
  bodies_.visitNear(centre, body.model->radius + its.way + longest_way_, [&](BodyIndex other_index) {
    const Body& other = bodies_[other_index];
    RigidBody& reached = rigid(other_index);
    const double gap = bodies_.distanceTo(other_index, centre) - body.model->radius;
    if (other_index != index && gap <= its.way + reached.way &&
        body.model->band.meets(other.model->band, body.along, other.along)) {
      its.is_reached = true;
      const bool is_news = !reached.is_reached;
      reached.is_reached = true;
      if (is_news && !reached.is_fast && other.is_movable && other.role == Role::kMove) {
        reached.is_fast = true;  // if it is hit
        reached.way = its.way;
        warnOthers(other_index);
      }
    }
    return true;
  });
}

void Dynamics2d::lookAround(BodyIndex index) {
  const Body& body = bodies_[index];
  const Eigen::Vector2d& centre = body.pose.position;
  double gap = kLookAhead;
  bodies_.visitNear(centre, body.model->radius + kLookAhead, [&](BodyIndex other_index) {
    const Body& other = bodies_[other_index];
    if (other_index != index && !rigid(other_index).is_fast &&
        body.model->band.meets(other.model->band, body.along, other.along)) {
      gap = std::min(gap, bodies_.distanceTo(other_index, centre) - body.model->radius);
    }
    return true;
  });
  rigid(index).free_until = travelled_ + 0.5 * gap;  // both may come
}

void Dynamics2d::enterBox2d(BodyIndex index) {
  RigidBody& its = rigid(index);
  if (its.is_alone) {
    its.is_alone = false;
    its.writeTransform();
    its.setVelocity(its.velocity, its.spin);
    its.body->SetEnabled(true);
  }
}

void Dynamics2d::leaveBox2d(BodyIndex index) {
  RigidBody& its = rigid(index);
  if (!its.is_alone) {
    its.velocity = its.velocityNow();
    its.spin = its.spinNow();
    its.is_alone = true;
    dropBelt(its);
    its.body->SetEnabled(false);
  }
}

void Dynamics2d::moveAlone(double tick) {
  const double step = tick / subclock_;
  for (const BodyIndex index : movers_) {
    RigidBody& its = rigid(index);
    if (its.is_alone && its.drive != Drive::kNone) {
      for (int i = 0; i < subclock_; ++i) {
        driveAlone(its, step, i);
      }
    }
  }
  for (planar::Turret& turret : bodies_.turrets()) {
    if (rigid(turret.body).is_alone) {
      for (int i = 0; i < subclock_; ++i) {
        turnFreely(turret, step);
      }
    }
  }
}

const b2World& Dynamics2d::world() {
  for (const BodyIndex index : movers_) {
    RigidBody& its = rigid(index);
    if (its.is_alone) {
      its.writeTransform();
      its.setVelocity(its.velocity, its.spin);
    }
  }
  return *world_;
}

}  // namespace swarmanoid::dynamics2d
