/// Pictures by rays (Embree): hidden surfaces, shadows of one sun, what is translucent. Rods are lines of a drawing,
/// beams, ropes: they have no shadow.
///
/// Threads  one call at a time; `render` takes as many as it was given.
/// Bits     pictures are looked at: they need not be equal on other machines. Nothing of a run depends on them.
#pragma once

#include <memory>

#include "swarmanoid_rendering/camera.hpp"
#include "swarmanoid_rendering/geometry.hpp"
#include "swarmanoid_rendering/picture.hpp"

namespace swarmanoid {

class RayTracer {
 public:
  /// Each can be replaced without the others.
  enum class Part { kFixed, kMoving };

  struct Options {
    bool has_shadows = true;
    int samples = 2;  ///< rays a pixel along each side, from 1
  };

  /// @param threads from 1 @throws std::runtime_error if Embree cannot be started
  explicit RayTracer(int threads = 1);
  ~RayTracer();
  RayTracer(const RayTracer&) = delete;
  RayTracer& operator=(const RayTracer&) = delete;

  /// Replaces a part of what is seen. @throws std::bad_alloc
  void set(Part part, Geometry geometry);

  /// @param width, height in pixels, from 1
  Picture render(const Camera& camera, int width, int height, const Options& options) const;

  /// Towards the sun, of length 1.
  static Eigen::Vector3f sun();
  /// What there is where nothing is.
  static Eigen::Vector3f background();
  /// The part of a colour that is seen in shadow, or where the sun's rays only touch; the rest is the sun's.
  static constexpr float kAmbient = 0.5F;

 private:
  class Scene;
  std::unique_ptr<Scene> scene_;
  int threads_;
};

}  // namespace swarmanoid
