/// What cameras of mock robots have in common: they see beacons and spots of light, and nothing hides anything.
#pragma once

#include <functional>
#include <vector>

#include "mock_state.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {

/// Returns whether a camera sees something. @param way to it from the camera, in the robot's frame [m]
using IsInView = std::function<bool(const Eigen::Vector3d& way)>;

/// Returns the blobs that a camera of the robot reports: beacons in the order of the world's file, then spots. All are
/// as small as LEDs. @param camera where it sits in the robot's frame [m] @param knows_distance or it says NaN
std::vector<ColorBlob> blobsInView(const MockState& state, const Eigen::Vector3d& camera, const IsInView& is_in_view,
                                   bool knows_distance = true);

}  // namespace swarmanoid::mock
