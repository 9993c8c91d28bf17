// State of the engine, for snapshots: motions, grips and contact forces; shapes for contacts are made anew.
#include "dynamics2d/dynamics2d.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// All that a body keeps between ticks, besides its grip and its shapes.
void archiveMotion(StateArchive& state, RigidBody& body) {
  state(body.is_fast, body.is_reached, body.is_present, body.way, body.jump, body.free_until, body.velocity, body.spin,
        body.centre, body.heading, body.mass, body.inertia, body.arm);
  state(body.centre_advance, body.turn_rate, body.treels, body.traction, body.drive, body.held_by, body.treel_forces,
        body.last_push);
}

}  // namespace

void Dynamics2d::archive(const Space& /*space*/, StateArchive& state) {
  std::vector<bool> had_own;
  for (const BodyIndex index : bodies_.order()) {
    had_own.push_back(bodies_.details(index).own != nullptr);
  }
  bodies_.archive(state);
  auto had = had_own.cbegin();
  for (const BodyIndex index : bodies_.order()) {
    RigidBody& body = rigid(index);
    const Eigen::Vector2d arm = body.arm;
    archiveMotion(state, body);
    Grip& grip = body.grip;
    bodies_.archiveIndex(state, grip.gripped);
    state(grip.is_torn, grip.must_open, grip.has_turret, grip.on_gripper, grip.on_held, grip.angle, grip.impulse);
    if (state.isLoading() && (*had || bodies_.details(index).own != nullptr || body.arm != arm)) {
      forgetShapes(index);
    }
    ++had;
  }
  state(crowd_memory_, travelled_);
  if (state.isLoading()) {
    present_.clear();
    contacts_.clear();
    grippers_.clear();
    for (const BodyIndex index : bodies_.order()) {
      if (rigid(index).grip.isHolding()) {
        grippers_.push_back(index);
      }
    }
  }
}

}  // namespace swarmanoid::dynamics2d
