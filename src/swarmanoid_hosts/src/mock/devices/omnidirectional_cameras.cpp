// Footbots and eyebots have a camera that sees all around, up to its range.
#include "../sight.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {
namespace {

template <class Camera>
class MockOmnidirectionalCamera final : public MockCamera<Camera> {
 public:
  using MockCamera<Camera>::MockCamera;

 protected:
  View view(const MockState& /*state*/) const override { return {{0.0, 0.0, Camera::kMount}, Camera::kUsualRange}; }
};

REGISTER_MOCK_DEVICE(FootbotCamera, MockOmnidirectionalCamera<FootbotCamera>)
REGISTER_MOCK_DEVICE(EyebotOmnidirectionalCamera, MockOmnidirectionalCamera<EyebotOmnidirectionalCamera>)

}  // namespace
}  // namespace swarmanoid::mock
