/// Debug drawing of planar bodies.
#pragma once

#include "planar/bodies.hpp"
#include "swarmanoid_space/engine_drawing.hpp"

namespace swarmanoid::planar {

/// Adds the outlines of all shapes, at the top and at the bottom of their bands.
void drawShapes(const Bodies& bodies, EngineDrawing& drawing);

/// Adds a line in the plane, at the middle height of a body.
void drawLine(const Bodies& bodies, BodyIndex at_height_of, EngineDrawing::Kind kind, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to, EngineDrawing& drawing);

}  // namespace swarmanoid::planar
