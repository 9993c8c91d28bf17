// Changes of the engine between ticks: parameters, entities and their poses.
#include "dynamics3d/dynamics3d.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "common/unsupported_mechanisms.hpp"
#include "dynamics3d/collision/convex_overlap.hpp"
#include "dynamics3d/collision/solids.hpp"
#include "dynamics3d/contacts/ground_contacts.hpp"
#include "dynamics3d/mechanisms/treels.hpp"

#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid::dynamics3d {

std::string Dynamics3d::unsupportedClocktickReason(Duration clocktick) const {
  const double step = toSeconds(clocktick) / settings_.subclock;
  if (step <= kLongestStep * (1.0 + 1e-9)) {
    return "";
  }
  PlainTextStream text;
  text << "subclock: found " << settings_.subclock << " with ticks of " << 1e3 * toSeconds(clocktick)
       << " ms, which makes steps of " << 1e3 * step << " ms; allowed: steps of at most " << 1e3 * kLongestStep
       << " ms, here a subclock from " << std::ceil(toSeconds(clocktick) / kLongestStep - 1e-9);
  return text.str();
}

std::string Dynamics3d::unsupportedReason(const EntityModel& model, const std::vector<DeviceUse>& devices) const {
  if (model.is_movable && !(model.mass > 0.0)) {
    return "has no mass, so this engine cannot move it";
  }
  if (model.is_movable && model.inertia.llt().info() != Eigen::Success) {
    return "has an inertia that no body has, so this engine cannot move it";
  }
  std::string problem = unsupportedMechanismsReason(model, devices);
  return problem.empty() ? unsupportedGripperReason(model, devices) : problem;
}

void Dynamics3d::prepare(const EngineResources& resources) {
  ground_ = GroundSurface(resources.terrain,
                          settings_.has_ground ? std::optional<double>(settings_.ground_height) : std::nullopt);
}

std::string Dynamics3d::invalidPoseReason(const EntityModel& model, const Pose& pose) const {
  constexpr double kInGround = 1e-4;       // m
  constexpr double kInRoughGround = 2e-3;  // m: treels' balls are soft, so they may be that deep in a slope
  if (!model.is_movable || model.shapes.empty()) {
    return "";
  }
  PlainTextStream text;
  const Eigen::AlignedBox3d bounds = boundsOf(model, pose);
  if (ground_.isRoughAt(bounds)) {
    const double rise = riseOut(ground_, shapesOnGround(model), pose);
    if (rise > kInRoughGround) {
      text << "found at z = " << pose.position.z()
           << ", where it stands in the terrain, allowed: above it, here from z = " << pose.position.z() + rise;
    }
  } else if (settings_.has_ground && bounds.min().z() < settings_.ground_height - kInGround) {
    text << "found at z = " << pose.position.z() << ", where it reaches down to z = " << bounds.min().z()
         << ", allowed: above the ground, which is at z = " << settings_.ground_height;
  }
  return text.str();
}

Row Dynamics3d::overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const {
  const Body* found = nullptr;
  seen_.visitNear(boundsOf(model, pose), [&](const Body* body, const Eigen::AlignedBox3d&) {
    const bool is_older = found == nullptr || body->number < found->number;
    const bool is_ignored = std::find(ignored.begin(), ignored.end(), body->row) != ignored.end();
    if (!is_ignored && is_older && modelsOverlap(model, pose, body->seen(), body->pose)) {
      found = body;
    }
    return true;
  });
  return found == nullptr ? kNoRow : found->row;
}

void Dynamics3d::add(const Space& space, Row row, Role role) {
  const OdeLock lock(seed_);
  makeWorld();
  by_row_.fit(row) = makeBody(world_, space, row, role);
  Body& body = *by_row_[row];
  // the mirror of an older entity may be added later: the order is by number, not by arrival
  const auto place = std::upper_bound(order_.begin(), order_.end(), &body,
                                      [](const Body* a, const Body* b) { return a->number < b->number; });
  rankFrom(order_.insert(place, &body));
  left_out_.reserve(order_.capacity());
  findTurret(body, space);
  takePose(space, body);
  seen_.add(&body, boundsOf(body.seen(), body.pose));
  touches_.add(body);
  contacts_.forget();
  takeOverGrips(space, body);
  takeOverAttachments(space, body);
  settling_ = body.is_dynamic ? kSettlingSteps : settling_;
}

void Dynamics3d::rankFrom(std::vector<Body*>::iterator first) {
  for (auto body = first; body != order_.end(); ++body) {
    (*body)->rank = static_cast<int>(body - order_.begin());
  }
}

void Dynamics3d::takePose(const Space& space, Body& body) {
  body.steadiness = Steadiness{};
  constexpr double kFastest = 5.0;       // m/s: a faster mirror was placed elsewhere and did not move there
  constexpr double kFastestTurn = 20.0;  // rad/s
  const Span<const JointState> joints = space.joints[body.row];
  body.setPose(space.entities.pose[body.row], joints);
  body.is_seen_elsewhere = body.role == Role::kMirror && space.mover[body.row] != nullptr;
  if (body.rigid == nullptr) {
    return;
  }
  Twist twist = space.entities.twist[body.row];
  if (!body.is_dynamic && !(twist.linear.norm() < kFastest && twist.angular.norm() < kFastestTurn)) {
    twist = Twist{};
  }
  if (!body.is_dynamic) {
    twist.linear = meanVelocity(twist, toSeconds(space.clocktick));  // straight to the end of its entity's arc
  }
  body.setTwist(twist, joints);
  takeTurret(body, space);
  if (body.model->wheels) {
    takeSpeed(body, twist);  // a body that arrives at speed keeps it
  }
}

void Dynamics3d::remove(const Space&, Row row) {
  const OdeLock lock(seed_);
  Body* body = by_row_[row].get();
  forgetHolds(*body);
  touches_.remove(*body);
  contacts_.forget();
  seen_.remove(body);
  rankFrom(order_.erase(std::find(order_.begin(), order_.end(), body)));
  by_row_[row].reset();
}

void Dynamics3d::place(const Space& space, Row row) {
  const OdeLock lock(seed_);
  Body& body = *find(row);
  forgetHolds(body);
  body.treels = Treels{};
  body.flight = Flight{};
  takePose(space, body);
  seen_.remove(&body);
  seen_.add(&body, boundsOf(body.seen(), body.pose));
  touches_.remove(body);
  touches_.add(body);
  contacts_.forget();
  settling_ = body.is_dynamic ? kSettlingSteps : settling_;
}

void Dynamics3d::clear() {
  const OdeLock lock(seed_);
  destroyWorld();
}

Dynamics3d::~Dynamics3d() {
  const OdeLock lock(seed_);
  destroyWorld();
}

void Dynamics3d::makeWorld() {
  constexpr double kFastestCorrection = 0.3;  // m/s: separation speed of bodies that were placed into each other
  constexpr double kFastestTurn = 200.0;      // rad/s
  if (world_ != nullptr) {
    return;
  }
  world_ = dWorldCreate();
  dWorldSetGravity(world_, 0.0, 0.0, -settings_.gravity);
  setDamping(true);
  dWorldSetContactMaxCorrectingVel(world_, kFastestCorrection);
  dWorldSetMaxAngularSpeed(world_, kFastestTurn);
  dWorldSetQuickStepNumIterations(world_, settings_.iterations);
  // when more bodies touch than before, the memory for a step grows, by so much that it hardly happens again
  const dWorldStepReserveInfo memory = {sizeof(dWorldStepReserveInfo), 2.0F, 1U << 20U};
  dWorldSetStepMemoryReservationPolicy(world_, &memory);
  touches_.configure(settings_, ground_);
  contacts_.configure(world_, settings_);
}

void Dynamics3d::destroyWorld() {
  // remaining state would make the next world differ from the first
  order_.clear();
  seen_.clear();
  by_row_.clear();
  touches_.release();
  contacts_.release();
  if (world_ != nullptr) {
    dWorldDestroy(world_);
    world_ = nullptr;
  }
  dRandSetSeed(0);  // the current lock writes it to `seed_` when it ends
  counts_ = SolverCounts{};
  has_reported_trouble_ = false;
  has_reported_islands_ = false;
  islands_.clear();
}

}  // namespace swarmanoid::dynamics3d

REGISTER_ENGINE(swarmanoid::dynamics3d::Dynamics3d)
