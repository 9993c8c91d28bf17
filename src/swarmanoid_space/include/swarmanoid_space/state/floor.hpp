/// The layers of floor colours, from bottom to top: bare ground, an image, patches, paint; and the floor's holes. Call
/// Floor::colorAt for the colour at a point, without reading single layers; only cameras, which see a patch as an
/// object, and drawings read the layers that they show. Space::holeAt tells whether there is floor at a point.
///
/// Frame W, SI. A colour belongs to a point of the plan: it is the same at any height, on rough ground too. Bare
/// ground, image, patches and holes come from the experiment file; they are constant, and in no hash. Paint is added
/// while the experiment runs, and is in the hash. Threads: const functions may run concurrently.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/state/paint_layer.hpp"

namespace swarmanoid {

/// A part of the floor, as seen from above.
struct FloorArea {
  std::string id;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre [m]
  double radius = 0.0;                                 ///< a disc [m]; 0: a rectangle of `size`
  Eigen::Vector2d size = Eigen::Vector2d::Zero();      ///< along x and y [m]
  SourceLocation location;

  /// Whether the point is above, on or below the area, its border included.
  bool contains(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d offset = (point - position).head<2>();
    if (radius > 0.0) {
      return offset.squaredNorm() <= radius * radius;
    }
    return std::abs(offset.x()) <= 0.5 * size.x() && std::abs(offset.y()) <= 0.5 * size.y();
  }
  /// Whether any part of it is within a distance of the point, as seen from above; in doubt, true.
  bool isNear(const Eigen::Vector3d& point, double distance) const {
    const Eigen::Vector2d half = radius > 0.0 ? Eigen::Vector2d(radius, radius) : Eigen::Vector2d(0.5 * size);
    return ((point - position).head<2>().cwiseAbs() - half).maxCoeff() <= distance;
  }
  /// The area's point that is closest to `point`, at the area's height.
  Eigen::Vector3d nearestPoint(const Eigen::Vector3d& point) const;
};

/// A coloured patch on the floor, such as the nest. Cameras and ground sensors see it; nothing collides with it.
struct FloorPatch : FloorArea {
  Color color;
};

/// An opening in the floor. Entities on the floor fall into it (phases/fall.cpp), ground sensors receive no reflection
/// from it; cameras do not see it.
struct FloorHole : FloorArea {};

/// A picture on the bare floor, below the patches. Its upper edge is at the largest y. A pixel is a rectangle of one
/// colour; on the border of two pixels the one with the larger coordinates counts, except on the outer border.
struct FloorImage {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< corner of least coordinates [m]
  Eigen::Vector2d size = Eigen::Vector2d::Ones();    ///< along x and y [m]
  int columns = 0;
  int rows = 0;
  std::vector<Color> colors;    ///< row after row from the top
  std::vector<char> is_opaque;  ///< same order as `colors`; 0: the bare floor is visible there

  /// @return null outside the image, or where it is transparent
  const Color* colorAt(const Eigen::Vector3d& point) const;
};

struct Floor {
  Color bare = colors::kWhite;              ///< colour without image, patch and paint
  std::shared_ptr<const FloorImage> image;  ///< null: none
  std::vector<FloorPatch> patches;          ///< in the order of the file: later patches are on top of earlier ones
  PaintLayer paint;
  std::vector<FloorHole> holes;  ///< in the order of the file; of the level floor, not of a terrain

  /// The colour above, on or below which the point lies. @param tick current tick (Space::tick)
  /// Inline, since sensors call it often.
  Color colorAt(const Eigen::Vector3d& point, std::uint64_t tick) const {
    return paint.over(unpaintedColorAt(point), point.head<2>(), tick);
  }
  /// The same without paint: of the top patch there, else of the image, else of the bare floor.
  Color unpaintedColorAt(const Eigen::Vector3d& point) const {
    for (auto patch = patches.rbegin(); patch != patches.rend(); ++patch) {
      if (patch->contains(point)) {
        return patch->color;
      }
    }
    const Color* of_image = image ? image->colorAt(point) : nullptr;
    return of_image != nullptr ? *of_image : bare;
  }
  /// Whether colorAt returns `bare` for all points within a distance of this one; in doubt, false. For callers that
  /// read many colours there.
  bool isBareAround(const Eigen::Vector3d& point, double distance) const {
    return !image && paint.spotCount() == 0 &&
           std::none_of(patches.begin(), patches.end(),
                        [&](const FloorPatch& patch) { return patch.isNear(point, distance); });
  }
};

}  // namespace swarmanoid
