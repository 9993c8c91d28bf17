// Changes of the engine between ticks, and rays that need no cast because the space around them is known to be free.
#include "kinematics2d/kinematics2d.hpp"

#include <algorithm>

#include "planar/body_rays.hpp"
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

void Kinematics2d::add(const Space& space, Row row, Role role) {
  const BodyIndex index = bodies_.add(space, row, role);
  motions_.resize(std::max(motions_.size(), static_cast<std::size_t>(index) + 1));
  clearances_.resize(motions_.size());
  neighbours_.resize(motions_.size());
  motion(index) = Motion{};
  clearance(index) = Clearance{};
  neighbours(index) = Neighbours{};
  takeOverGrips(space, index);
  is_somebody_new_ = true;
  are_lists_old_ = true;
}

void Kinematics2d::remove(const Space&, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  bodies_.remove(index);
  is_somebody_new_ = true;  // lists of neighbours contain the removed body
  are_lists_old_ = true;
}

void Kinematics2d::place(const Space& space, Row row) {
  const BodyIndex index = bodies_.find(row);
  forgetGrips(index);
  bodies_.place(space, index);
  is_somebody_new_ = true;
  are_lists_old_ = true;
}

bool Kinematics2d::mayHit(const RayBundle& rays) const { return !areAllOutOfReach(rays) && PlanarEngine::mayHit(rays); }

void Kinematics2d::findObstacles(const RayBundle& rays, Obstacles& found) const {
  const BodyIndex caster = hitsPrisms() ? kNoBody : casterOf(rays);
  if (caster != kNoBody) {
    const double beyond = reachBeyond(caster, rays);
    if (isClear(caster, beyond)) {
      return;
    }
    const Neighbours& near = neighbours(caster);
    if (near.gapToOthers(travelled_) > beyond) {
      const Eigen::Vector2d middle = bodies_.plane().toLocal(rays.centre);
      for (std::size_t i = 0; i < near.count && !found.areAnywhere(); ++i) {
        planar::addObstacle(*this, bodies_, near.bodies[i], rays, middle, found);
      }
      return;
    }
  }
  PlanarEngine::findObstacles(rays, found);
}

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

/// The robot that casts rays around itself, if the neighbours found while moving it are still valid; else kNoBody.
BodyIndex Kinematics2d::casterOf(const RayBundle& rays) const {
  return rays.ignored == kNoRow || is_somebody_new_ ? kNoBody : bodies_.find(rays.ignored);
}

/// Upper bound on the reach of rays beyond the circle around a body [m].
double Kinematics2d::reachBeyond(BodyIndex index, const RayBundle& rays) const {
  const planar::Bodies::Circle& body = bodies_.circle(index);
  return (bodies_.plane().toLocal(rays.centre) - body.centre).norm() + rays.radius - body.radius;
}

/// Whether the clearance of a body keeps all others, at any height, farther away than `distance` [m].
bool Kinematics2d::isClear(BodyIndex index, double distance) const {
  const Clearance& around = clearance(index);
  return around.at_all_heights && 2.0 * (around.free_until - travelled_) > distance;
}

bool Kinematics2d::areAllOutOfReach(const RayBundle& rays) const {
  const BodyIndex caster = casterOf(rays);
  return caster != kNoBody && isClear(caster, reachBeyond(caster, rays));
}

}  // namespace swarmanoid::kinematics2d

REGISTER_ENGINE(swarmanoid::kinematics2d::Kinematics2d)
