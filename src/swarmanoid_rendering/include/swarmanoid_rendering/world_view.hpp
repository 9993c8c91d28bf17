/// A space as rviz shows it, for pictures: arena, links of robots posed by their joints, LEDs, beams, grips, ropes.
/// Texts and the drawings of devices and engines are left out.
///
/// Robots  up to Transforms::kFewRobots have the bodies of their URDF; with more, all are balls, as in rviz.
/// Phase   both functions: `show`, on the simulation's thread.
/// Errors  std::runtime_error for a mesh of a robot that cannot be read
#pragma once

#include <memory>

#include "swarmanoid_rendering/ray_tracer.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class WorldView {
 public:
  /// @param has_textures whether the floor has its image
  explicit WorldView(bool has_textures);
  ~WorldView();
  WorldView(const WorldView&) = delete;
  WorldView& operator=(const WorldView&) = delete;

  /// Notes whether entities were added, deleted, moved or recoloured from outside, so that the fixed part has to be
  /// drawn anew. Call it once before the first tick and after each.
  void follow(const Space& space);
  /// Updates the tracer to the current state of the space; the fixed part only if `follow` noted changes.
  void show(const Space& space, RayTracer& tracer);

 private:
  class Markers;
  std::unique_ptr<Markers> markers_;
};

}  // namespace swarmanoid
