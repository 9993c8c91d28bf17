/// Reads URDF files, strictly; and what their parts have in common.
#pragma once

#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <Eigen/Core>
#include <string>

#include "../xml/xml_document.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// How exactly a file must say what has to be equal, straight or centred [m, rad].
constexpr double kSamePlace = 1e-6;

struct UrdfFile {
  std::string file;
  std::string text;
  XmlDocument document;
  urdf::ModelInterfaceSharedPtr robot;

  /// @throws ConfigError
  [[noreturn]] void fail(const std::string& message) const;
};

/// Thread-safe.
/// @throws ConfigError naming the file if it cannot be read, is not XML, or if urdfdom complains about anything in it
UrdfFile readUrdf(const std::string& file);

Mount toMount(const urdf::Pose& pose);

/// Where something is in the body frame, given where it is in a frame on the body.
Mount chain(const Mount& frame, const Mount& inner);

/// Where the body is in a frame on it.
Mount inverse(const Mount& frame);

/// "x y z", as in a URDF.
std::string coordinates(const Eigen::Vector3d& v);

}  // namespace swarmanoid
