// What changes in the engine between ticks, and the rays that are not cast because the space around them is known to be
// free.
#include "kinematics2d/kinematics2d.hpp"

#include <algorithm>

#include "planar/draw_bodies.hpp"

namespace swarmanoid::kinematics2d {

PluginDescription Kinematics2d::describe() {
  PluginDescription description;
  description.label = "kinematics2d";
  description.label_aliases = {"dummy_engine"};
  description.summary = "Two-dimensional kinematics: velocities, collisions, gripping of preys; no masses, no forces.";
  description.parameters = placementParameters();
  return description;
}

void Kinematics2d::add(Space& space, Row row, Role role) {
  const BodyIndex index = bodies_.add(space, row, role);
  motions_.resize(std::max(motions_.size(), static_cast<std::size_t>(index) + 1));
  clearances_.resize(motions_.size());
  motion(index) = Motion{};
  clearance(index) = Clearance{};
  takeOverGrips(space, index);
  is_somebody_new_ = true;
  are_lists_old_ = true;
}

void Kinematics2d::remove(Space&, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  bodies_.remove(index);
  are_lists_old_ = true;
}

void Kinematics2d::place(Space& space, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  bodies_.place(space, index);
  is_somebody_new_ = true;
  are_lists_old_ = true;
}

bool Kinematics2d::mayHit(const RayBundle& rays) const { return !areAllOutOfReach(rays) && PlanarEngine::mayHit(rays); }

void Kinematics2d::raycast(const RayBundle& rays, Span<RayHit> hits) const {
  if (!areAllOutOfReach(rays)) {
    PlanarEngine::raycast(rays, hits);
  }
}

void Kinematics2d::draw(EngineDrawing& drawing) const {
  PlanarEngine::draw(drawing);
  for (const BodyIndex index : bodies_.order()) {
    if (const BodyIndex gripped = motion(index).gripped; gripped != kNoBody) {
      planar::drawLine(bodies_, index, EngineDrawing::Kind::kJoint, bodies_[index].pose.position,
                       bodies_[gripped].pose.position, drawing);
    }
  }
}

bool Kinematics2d::areAllOutOfReach(const RayBundle& rays) const {
  // the clearance of a robot that casts rays, found while moving it, bounds the distance of all other bodies
  const BodyIndex caster = rays.ignored == kNoRow || is_somebody_new_ ? kNoBody : bodies_.find(rays.ignored);
  if (caster == kNoBody) {
    return false;
  }
  const planar::Bodies::Circle& body = bodies_.circle(caster);
  const Clearance& around = clearance(caster);
  const double room = body.radius + 2.0 * (around.free_until - travelled_) - rays.radius;
  const Eigen::Vector2d centre = bodies_.plane().toLocal(rays.centre);
  return around.at_all_heights && room > 0.0 && (centre - body.centre).squaredNorm() < room * room;
}

}  // namespace swarmanoid::kinematics2d

REGISTER_ENGINE(swarmanoid::kinematics2d::Kinematics2d)
