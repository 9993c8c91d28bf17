// State of bodies, for snapshots.
#include "planar/bodies.hpp"

namespace swarmanoid::planar {
namespace {

bool areSame(const PlacedPose& a, const PlacedPose& b) {
  return a.position == b.position && a.heading == b.heading && a.cosine == b.cosine && a.sine == b.sine;
}

}  // namespace

void Bodies::archive(StateArchive& state) {
  for (const BodyIndex index : order_) {
    Body& body = (*this)[index];
    PlacedPose pose = body.pose;
    bool has_moved = body.has_moved;
    state(pose, body.velocity, body.turn_rate, body.along, body.is_seen_elsewhere, has_moved);
    archiveProjection(state, index);
    if (!areSame(pose, body.pose)) {
      setPose(index, pose);
    }
    body.has_moved = has_moved;
  }
  for (Turret& turret : turrets_) {
    state(turret.state, turret.angle_at_start, turret.held);
  }
}

/// The projection of a body: its own, with its joints, or the shared one of its model and base.
void Bodies::archiveProjection(StateArchive& state, BodyIndex index) {
  BodyDetails& record = details(index);
  bool has_own = record.own != nullptr;
  Eigen::Quaterniond base = record.base;
  state(has_own, base);
  const bool has_changed = has_own || record.own != nullptr || base.coeffs() != record.base.coeffs();
  record.base = base;
  if (has_own) {
    state(ownProjection(index).joints);
  }
  if (!state.isLoading() || !has_changed) {
    return;
  }
  if (has_own) {
    takeProjection(index);
    return;
  }
  record.own.reset();
  record.shared_model = project(record.entity, record.base);
  (*this)[index].model = record.shared_model.get();
  circles_[static_cast<std::size_t>(index)].radius = record.shared_model->radius;
}

}  // namespace swarmanoid::planar
