// An eyebot's camera looks down into a cone.
#include <cmath>

#include "../mock_device.hpp"
#include "../sight.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotCamera final : public MockDevice {
 public:
  MockEyebotCamera(EyebotCamera& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const double slope = std::tan(EyebotCamera::kUsualAperture);
    blobs_ = blobsInView(state, {0.0, 0.0, EyebotCamera::kMount}, [slope](const Eigen::Vector3d& way) {
      const double horizontal = way.head<2>().norm();
      return horizontal <= EyebotCamera::kUsualRange && horizontal <= slope * -way.z();
    });
    readings_.blobs = blobs_;
  }

 private:
  EyebotCamera& readings_;
  std::vector<ColorBlob> blobs_;
};

REGISTER_MOCK_DEVICE(EyebotCamera, MockEyebotCamera)

}  // namespace
}  // namespace swarmanoid::mock
