/// The colours of the floor, one over the other: bare ground, an image, patches, paint; and its holes. Whoever needs
/// the floor's colour at a place asks Floor::colorAt, and looks at none of them for it; cameras, which see a patch as a
/// thing, and drawings look at what they show. Whether there is a floor at a place says Space::holeAt.
///
/// Frame W, SI. A colour belongs to a place of the plan: it is the same at any height, on rough ground too. An
/// experiment file says what bare ground, image, patches and holes are like; they are the same in all ticks, and in no
/// hash.
/// Paint is put on the floor while the experiment runs, and is in the hash. Threads: const from any number of them.
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

  /// Whether the point lies above (or on, or below) the area, its border included.
  bool contains(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d offset = (point - position).head<2>();
    if (radius > 0.0) {
      return offset.squaredNorm() <= radius * radius;
    }
    return std::abs(offset.x()) <= 0.5 * size.x() && std::abs(offset.y()) <= 0.5 * size.y();
  }
  /// Whether any of it lies within a distance of the point, as seen from above; in doubt, yes.
  bool isNear(const Eigen::Vector3d& point, double distance) const {
    const Eigen::Vector2d half = radius > 0.0 ? Eigen::Vector2d(radius, radius) : Eigen::Vector2d(0.5 * size);
    return ((point - position).head<2>().cwiseAbs() - half).maxCoeff() <= distance;
  }
  /// The area's point nearest to `point`, at the area's height.
  Eigen::Vector3d nearestPoint(const Eigen::Vector3d& point) const;
};

/// A coloured patch on the floor, such as the nest. Cameras and ground sensors see it, nothing collides with it.
struct FloorPatch : FloorArea {
  Color color;
};

/// Where there is no floor. What stands on the floor falls into it (phases/fall.cpp), ground sensors get nothing back
/// from it; cameras do not see it.
struct FloorHole : FloorArea {};

/// A picture on the bare floor, below the patches. Its upper edge is where y is largest. A pixel is a rectangle of one
/// colour; of two that a point lies between the one with the larger coordinates counts, but at the outer border.
struct FloorImage {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< the one with the smallest coordinates [m]
  Eigen::Vector2d size = Eigen::Vector2d::Ones();    ///< along x and y [m]
  int columns = 0;
  int rows = 0;
  std::vector<Color> colors;    ///< row after row from the top
  std::vector<char> is_opaque;  ///< likewise; 0: bare floor is seen there

  /// @return null where the image is not, or is transparent
  const Color* colorAt(const Eigen::Vector3d& point) const;
};

struct Floor {
  Color bare = colors::kWhite;              ///< where there is nothing else
  std::shared_ptr<const FloorImage> image;  ///< null: none
  std::vector<FloorPatch> patches;          ///< in the order of the file: later ones lie on earlier ones
  PaintLayer paint;
  std::vector<FloorHole> holes;  ///< in the order of the file; of the level floor, not of a terrain

  /// The colour above, on or below which the point lies. @param tick under way (Space::tick)
  /// In the header, since sensors ask for it often.
  Color colorAt(const Eigen::Vector3d& point, std::uint64_t tick) const {
    return paint.over(unpaintedColorAt(point), point.head<2>(), tick);
  }
  /// The same without paint: of the last patch there, else of the image, else of the bare floor.
  Color unpaintedColorAt(const Eigen::Vector3d& point) const {
    for (auto patch = patches.rbegin(); patch != patches.rend(); ++patch) {
      if (patch->contains(point)) {
        return patch->color;
      }
    }
    const Color* of_image = image ? image->colorAt(point) : nullptr;
    return of_image != nullptr ? *of_image : bare;
  }
  /// Whether colorAt says `bare` of all points within a distance of this one; in doubt, no. For whoever asks for many
  /// colours there.
  bool isBareAround(const Eigen::Vector3d& point, double distance) const {
    return !image && paint.spotCount() == 0 &&
           std::none_of(patches.begin(), patches.end(),
                        [&](const FloorPatch& patch) { return patch.isNear(point, distance); });
  }
};

}  // namespace swarmanoid
