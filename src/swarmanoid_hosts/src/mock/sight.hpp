/// What cameras of mock robots have in common: they see beacons and spots of light, and nothing hides anything.
#pragma once

#include <functional>
#include <vector>

#include "mock_device.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {

/// What a camera sees.
struct View {
  Eigen::Vector3d camera;  ///< where it sits, in the robot's frame [m]
  double range;            ///< horizontal distance beyond which it sees nothing [m]
  /// Whether something within that range is in its picture. @param way to it from the camera, in the robot's frame [m]
  std::function<bool(const Eigen::Vector3d& way)> shows = [](const Eigen::Vector3d& /*way*/) { return true; };
  bool knows_distance = true;  ///< or it says NaN
};

/// Returns the blobs that a camera of the robot reports: beacons in the order of the world's file, then spots. All are
/// as small as LEDs.
std::vector<ColorBlob> blobsInView(const MockState& state, const View& view);

/// The mock of a camera, of which its class says the view.
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
