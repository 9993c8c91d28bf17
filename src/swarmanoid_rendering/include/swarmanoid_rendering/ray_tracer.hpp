/// Ray tracer (Embree) with hidden surfaces, shadows of one sun, and translucency. Rods stand for drawn lines, beams
/// and ropes, so they cast no shadow.
///
/// Threads  one call at a time; `render` uses as many threads as the constructor was given.
/// Bits     pictures may differ between machines; no result of a run depends on them.
#pragma once

#include <memory>

#include "swarmanoid_rendering/camera.hpp"
#include "swarmanoid_rendering/geometry.hpp"
#include "swarmanoid_rendering/picture.hpp"

namespace swarmanoid {

class RayTracer {
 public:
  /// Each part can be replaced without the other.
  enum class Part { kFixed, kMoving };

  struct Options {
    bool has_shadows = true;
    int samples = 2;  ///< rays per pixel along each side, from 1
  };

  /// @param threads from 1 @throws std::runtime_error if Embree cannot be started
  explicit RayTracer(int threads = 1);
  ~RayTracer();
  RayTracer(const RayTracer&) = delete;
  RayTracer& operator=(const RayTracer&) = delete;

  /// Replaces one part of the scene. @throws std::bad_alloc
  void set(Part part, Geometry geometry);

  /// @param width, height in pixels, from 1
  Picture render(const Camera& camera, int width, int height, const Options& options) const;

  /// Unit vector towards the sun.
  static Eigen::Vector3f sun();
  /// Colour of rays that hit nothing.
  static Eigen::Vector3f background();
  /// Fraction of a colour that is visible in shadow and on surfaces that face away from the sun; the sun adds the rest.
  static constexpr float kAmbient = 0.5F;

 private:
  class Scene;
  std::unique_ptr<Scene> scene_;
  int threads_;
};

}  // namespace swarmanoid
