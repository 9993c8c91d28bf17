// Bodies that nothing can reach in a tick move alone, without a search for contacts. In a swarm those are nearly all
// robots, which leaves time for steps as fine as the other bodies need.
#include <algorithm>
#include <cmath>

#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {
namespace {
constexpr double kFastWay = 0.14;  // m in a tick: the few faster bodies search for all others
}  // namespace

Dynamics2d::Rates Dynamics2d::highestRates(BodyIndex index) {
  const Body& body = bodies_[index];
  const RigidBody& rigid_body = rigid(index);
  return {std::sqrt(std::max(rigid_body.velocity.squaredNorm(), body.velocity.squaredNorm())),
          std::max(std::abs(rigid_body.spin), std::abs(body.turn_rate))};
}

double Dynamics2d::highestSpeed(BodyIndex index) {
  const Rates most = highestRates(index);
  return most.speed + most.turn * bodies_[index].model->radius;
}

void Dynamics2d::measureWay(BodyIndex index, double tick, double jump) {
  RigidBody& rigid_body = rigid(index);
  const Rates most = highestRates(index);
  // a body that is hit may be twice as fast as the body that hits it
  rigid_body.way = 2.0 * (most.speed + most.turn * rigid_body.arm.norm()) * tick + jump + kContactMargin;
  rigid_body.is_reached = false;
  const bool was_fast = rigid_body.is_fast;
  rigid_body.is_fast = rigid_body.way > kFastWay;
  if (was_fast && !rigid_body.is_fast) {
    travelled_ += kLookAhead;  // searches made while it was fast did not count it
  }
  longest_way_ = std::max(longest_way_, rigid_body.way);
  if (!rigid_body.is_fast) {
    longest_slow_way_ = std::max(longest_slow_way_, rigid_body.way);
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
    RigidBody& rigid_body = rigid(index);
    bool is_alone = !rigid_body.is_reached && !rigid_body.isConnected() &&
                    (rigid_body.drive != Drive::kNone || rigid_body.isAtRest());
    if (is_alone && !rigid_body.is_fast) {
      if (travelled_ + longest_slow_way_ > rigid_body.free_until) {
        lookAround(index);
      }
      is_alone = travelled_ + longest_slow_way_ <= rigid_body.free_until;
    }
    rigid_body.is_present = !is_alone;
    if (!is_alone) {
      rigid_body.rank = static_cast<int>(present_.size());
      present_.push_back(index);
    }
  }
  travelled_ += longest_slow_way_;
}

void Dynamics2d::warnOthers(BodyIndex index) {
  const Body& body = bodies_[index];
  RigidBody& rigid_body = rigid(index);
  const Eigen::Vector2d& centre = body.pose.position;
  bodies_.visitNear(centre, body.model->radius + rigid_body.way + longest_way_, [&](BodyIndex other_index) {
    const Body& other = bodies_[other_index];
    RigidBody& reached = rigid(other_index);
    const double gap = bodies_.distanceTo(other_index, centre) - body.model->radius;
    if (other_index != index && gap <= rigid_body.way + reached.way &&
        body.model->band.overlaps(other.model->band, body.along, other.along)) {
      rigid_body.is_reached = true;
      const bool is_news = !reached.is_reached;
      reached.is_reached = true;
      if (is_news && !reached.is_fast && other.is_movable && other.role == Role::kMove) {
        reached.is_fast = true;  // it may be hit
        reached.way = rigid_body.way;
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
        body.model->band.overlaps(other.model->band, body.along, other.along)) {
      gap = std::min(gap, bodies_.distanceTo(other_index, centre) - body.model->radius);
    }
    return true;
  });
  rigid(index).free_until = travelled_ + 0.5 * gap;  // both bodies may approach
}

void Dynamics2d::moveAlone(double tick) {
  const double step = tick / subclock_;
  for (const BodyIndex index : movers_) {
    if (!rigid(index).is_present && rigid(index).drive != Drive::kNone) {
      driveAlone(index, step, subclock_);
    }
  }
  for (planar::Turret& turret : bodies_.turrets()) {
    if (!rigid(turret.body).is_present) {
      for (int i = 0; i < subclock_; ++i) {
        turnFreely(turret, step);
      }
    }
  }
}

}  // namespace swarmanoid::dynamics2d
