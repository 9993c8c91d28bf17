/// Lines that show what planar bodies are made of.
#pragma once

#include "planar/bodies.hpp"
#include "swarmanoid_space/engine_drawing.hpp"

namespace swarmanoid::planar {

/// The outlines of all bodies' shapes, at the top and at the bottom of the band of heights that they fill.
void drawShapes(const Bodies& bodies, EngineDrawing& drawing);

/// A line in the plane, at a body's middle height.
void drawLine(const Bodies& bodies, BodyIndex at_height_of, EngineDrawing::Kind kind, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to, EngineDrawing& drawing);

}  // namespace swarmanoid::planar
