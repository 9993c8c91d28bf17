/// The shapes of bodies as Box2D gets them.
///
/// Box2D keeps a skin around polygons, which it holds others off by, and lets all shapes rest one slop deep in each
/// other. Polygons are drawn in and circles widened by what makes bodies rest where the surfaces of their models meet.
#pragma once

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_polygon_shape.h>

#include "dynamics2d/units.hpp"
#include "planar/bodies.hpp"

namespace swarmanoid::dynamics2d {

/// The thinnest shape that Box2D can be given [m].
constexpr double kThinnest = 1e-3;

/// What each shape is wider by. Bodies that rest on each other may be anywhere between not touching and one slop deep,
/// as Box2D has them: so their surfaces are half a slop apart, at most, or as deep in each other [m].
constexpr double kWidening = 0.25 * kSlop;

/// Gives a body its shapes, as fixtures that know their number in the model. Box2D has polygons of up to eight corners:
/// those with more become several.
void addFixtures(b2Body& body, const planar::PlanarModel& model, float friction, float restitution);

/// Give Box2D's shapes the extent of a planar one. @pre it is a circle; a polygon with room for its corners in Box2D's
void setShape(const planar::PlanarShape& shape, b2CircleShape& circle);
void setShape(const planar::PlanarShape& shape, b2PolygonShape& polygon);

/// Puts the shapes that a joint turns where the projection of the model now has them.
void turnFixtures(b2Body& body, const planar::PlanarModel& model, const EntityModel& entity, int joint);

}  // namespace swarmanoid::dynamics2d
