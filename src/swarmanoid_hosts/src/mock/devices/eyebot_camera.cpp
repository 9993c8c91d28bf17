// An eyebot's camera looks down into a cone.
#include <cmath>

#include "../sight.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotCamera final : public MockCamera<EyebotCamera> {
 public:
  using MockCamera::MockCamera;

 protected:
  View view(const MockState& /*state*/) const override {
    const double slope = std::tan(EyebotCamera::kUsualAperture);
    return {{0.0, 0.0, EyebotCamera::kMount}, EyebotCamera::kUsualRange, [slope](const Eigen::Vector3d& way) {
              return way.head<2>().norm() <= slope * -way.z();
            }};
  }
};

REGISTER_MOCK_DEVICE(EyebotCamera, MockEyebotCamera)

}  // namespace
}  // namespace swarmanoid::mock
