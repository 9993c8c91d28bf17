/// The colours of the floor: patches on bare ground. Whoever needs the floor's colour at a place asks Floor::colorAt,
/// and looks at no patch for it; cameras, which see a patch as a thing, and drawings look at the patches.
///
/// Frame W, SI. A colour belongs to a place of the plan: it is the same at any height, on rough ground too. An
/// experiment file says what the floor is like; it is the same in all ticks, and in no hash. Threads: const from any
/// number of them.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// A coloured patch on the floor, such as the nest. Cameras and ground sensors see it, nothing collides with it.
struct FloorPatch {
  std::string id;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of its centre [m]
  double radius = 0.0;                                 ///< a disc [m]; 0: a rectangle of `size`
  Eigen::Vector2d size = Eigen::Vector2d::Zero();      ///< along x and y [m]
  Color color;
  SourceLocation location;

  /// Whether the point lies above (or on, or below) the patch, its border included.
  bool contains(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d offset = (point - position).head<2>();
    if (radius > 0.0) {
      return offset.squaredNorm() <= radius * radius;
    }
    return std::abs(offset.x()) <= 0.5 * size.x() && std::abs(offset.y()) <= 0.5 * size.y();
  }
  /// The patch's point nearest to `point`, at the patch's height.
  Eigen::Vector3d nearestPoint(const Eigen::Vector3d& point) const;
};

struct Floor {
  std::vector<FloorPatch> patches;  ///< in the order of the file: later ones lie on earlier ones
  Color bare = colors::kWhite;      ///< where there is no patch

  /// The colour above, on or below which the point lies: that of the last patch there, else that of the bare floor.
  /// In the header, since sensors ask for it often.
  Color colorAt(const Eigen::Vector3d& point) const {
    for (auto patch = patches.rbegin(); patch != patches.rend(); ++patch) {
      if (patch->contains(point)) {
        return patch->color;
      }
    }
    return bare;
  }
};

}  // namespace swarmanoid
