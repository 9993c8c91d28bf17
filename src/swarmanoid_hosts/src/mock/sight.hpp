/// What cameras of mock robots have in common: they see beacons and spots of light, and nothing hides anything.
#pragma once

#include <functional>
#include <vector>

#include "mock_state.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {

/// Returns whether a camera sees something. @param horizontal distance from the robot's axis [m] @param height of it
/// [m]
using IsInView = std::function<bool(double horizontal, double height)>;

/// Returns the blobs that a camera of the robot reports: beacons in the order of the world's file, then spots.
std::vector<ColorBlob> blobsInView(const MockState& state, const IsInView& is_in_view);

}  // namespace swarmanoid::mock
