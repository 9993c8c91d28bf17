// A footbot's camera sees all around, up to its range.
#include "../mock_device.hpp"
#include "../sight.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbotCamera final : public MockDevice {
 public:
  MockFootbotCamera(FootbotCamera& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    blobs_ = blobsInView(state,
                         [](double horizontal, double /*height*/) { return horizontal <= FootbotCamera::kUsualRange; });
    readings_.blobs = blobs_;
  }

 private:
  FootbotCamera& readings_;
  std::vector<ColorBlob> blobs_;
};

REGISTER_MOCK_DEVICE(FootbotCamera, MockFootbotCamera)

}  // namespace
}  // namespace swarmanoid::mock
