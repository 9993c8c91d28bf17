/// Triangles of mesh files (STL, Collada, ...) as URDF and rviz name them: package://PACKAGE/FILE, file:///FILE.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_rendering/geometry.hpp"

namespace swarmanoid {

class MeshFiles {
 public:
  struct Triangle {
    std::array<Eigen::Vector3d, 3> corners;
    std::optional<Tint> tint;  ///< of its material, if the file has one
  };

  /// Triangles of a .dae, .obj, .ply or .stl file, which passes checkMeshFile first. Each file is read once; the result
  /// lives as long as this object.
  /// @throws std::runtime_error with the file and the reason if it is missing, rejected, or cannot be read
  const std::vector<Triangle>& read(const std::string& resource);

 private:
  std::map<std::string, std::vector<Triangle>> known_;
};

}  // namespace swarmanoid
