/// Reads URDF files, strictly; and what their parts have in common.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Core>
#include <string>

#include "../xml/xml_document.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// How exactly a file must say what has to be equal or centred [m].
constexpr double kSamePlace = 1e-6;
/// How exactly it must say what has to be straight [rad]: published files have 1.57 for a quarter turn. Turns and axes
/// so near to one are taken for it.
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

/// Thread-safe.
/// @throws ConfigError naming the file if it cannot be read, is not XML, or if urdfdom complains about anything in it
UrdfFile readUrdf(const std::string& file);

/// Becomes an exact turn by quarters if each turned axis is within 2 * kSameDirection of an axis of the frame.
Mount toMount(const urdf::Pose& pose);

/// Of length 1, in a frame; what is within the tolerance of an axis of that is exactly the axis.
Eigen::Vector3d toAxis(const Eigen::Vector3d& direction, double tolerance = kSameDirection);

/// About the centre of mass, along the axes of the element's frame [kg m2].
Eigen::Matrix3d inertiaOf(const urdf::Inertial& inertial);

/// Where something is in the body frame, given where it is in a frame on the body.
Mount chain(const Mount& frame, const Mount& inner);

/// Where the body is in a frame on it.
Mount inverse(const Mount& frame);

/// "x y z", as in a URDF.
std::string coordinates(const Eigen::Vector3d& v);

}  // namespace swarmanoid
