/// Common parts of mock cameras: they see beacons and spots of light, without occlusion.
#pragma once

#include <functional>
#include <vector>

#include "mock_device.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {

/// The field of view of a camera.
struct View {
  Eigen::Vector3d camera;  ///< position in the robot's frame [m]
  double range;            ///< maximum horizontal distance [m]
  /// Returns whether an object in range is in the picture. @param way from the camera to it, in the robot's frame [m]
  std::function<bool(const Eigen::Vector3d& way)> shows = [](const Eigen::Vector3d& /*way*/) { return true; };
  bool knows_distance = true;  ///< else reported distances are NaN
};

/// Returns the blobs that a camera of the robot reports: beacons in the order of the world's file, then spots. All are
/// as small as LEDs.
std::vector<ColorBlob> blobsInView(const MockState& state, const View& view);

/// The mock of a camera; derived classes define its view.
template <class Camera>
class MockCamera : public MockDevice {
 public:
  MockCamera(Camera& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    blobs_ = blobsInView(state, view(state));
    readings_.blobs = blobs_;
  }

 protected:
  virtual View view(const MockState& state) const = 0;

 private:
  Camera& readings_;
  std::vector<ColorBlob> blobs_;
};

}  // namespace swarmanoid::mock
