/// A space as rviz shows it, for pictures: arena, robots' bodies where their joints have them, LEDs, beams, grips,
/// ropes. Texts, and what devices and engines draw, are left out.
///
/// Robots  up to Transforms::kFewRobots have the bodies of their URDF, more are balls, as in rviz.
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

  /// Notes whether what nobody moves has changed. To be called once before the first tick and after each.
  void follow(const Space& space);
  /// Gives the tracer what the space looks like now; what nobody moves only if it has changed since the last call.
  void show(const Space& space, RayTracer& tracer);

 private:
  class Markers;
  std::unique_ptr<Markers> markers_;
};

}  // namespace swarmanoid
