// Footbots and eyebots have a camera that sees all around, up to its range.
#include "../mock_device.hpp"
#include "../sight.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {
namespace {

template <class Camera>
class MockOmnidirectionalCamera final : public MockDevice {
 public:
  MockOmnidirectionalCamera(Camera& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    blobs_ = blobsInView(state, {0.0, 0.0, Camera::kMount},
                         [](const Eigen::Vector3d& way) { return way.head<2>().norm() <= Camera::kUsualRange; });
    readings_.blobs = blobs_;
  }

 private:
  Camera& readings_;
  std::vector<ColorBlob> blobs_;
};

REGISTER_MOCK_DEVICE(FootbotCamera, MockOmnidirectionalCamera<FootbotCamera>)
REGISTER_MOCK_DEVICE(EyebotOmnidirectionalCamera, MockOmnidirectionalCamera<EyebotOmnidirectionalCamera>)

}  // namespace
}  // namespace swarmanoid::mock
