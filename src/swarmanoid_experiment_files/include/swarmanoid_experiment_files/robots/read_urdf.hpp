/// Reads URDF files strictly, and converts their elements.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Core>
#include <string>

#include "swarmanoid_experiment_files/xml/xml_document.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// Tolerance for places that must be equal or centred [m].
constexpr double kSamePlace = 1e-6;
/// Tolerance for directions that must be straight [rad]: published files have 1.57 for a quarter turn. Turns and axes
/// within the tolerance of an exact one are replaced by it.
constexpr double kSameDirection = 1e-3;

struct UrdfFile {
  std::string file;
  std::string text;
  XmlDocument document;
  urdf::ModelInterfaceSharedPtr robot;

  /// @throws ConfigError
  [[noreturn]] void fail(const std::string& message) const;
};

/// @throws ConfigError if the file cannot be read, is empty, or longer than limits::kLongestText
std::string readUrdfText(const std::string& file);

/// Reads a URDF. Thread-safe.
/// @throws ConfigError naming the file if it cannot be read, is not XML, or if urdfdom reports an error in it
UrdfFile readUrdf(const std::string& file);

/// Converts a pose. Its orientation becomes an exact turn by quarters if each turned axis is within 2 * kSameDirection
/// of an axis of the frame.
Mount toMount(const urdf::Pose& pose);

/// Returns the direction with length 1; exactly an axis of the frame if it is within the tolerance of one.
Eigen::Vector3d toAxis(const Eigen::Vector3d& direction, double tolerance = kSameDirection);

/// Inertia about the centre of mass, along the axes of the element's frame [kg m2].
Eigen::Matrix3d inertiaOf(const urdf::Inertial& inertial);

/// Returns a mount in the body frame, given the mount in a frame on the body.
Mount chain(const Mount& frame, const Mount& inner);

/// Returns the mount of the body in a frame on it.
Mount inverse(const Mount& frame);

/// Returns "x y z", as in a URDF.
std::string coordinates(const Eigen::Vector3d& v);

}  // namespace swarmanoid
