// Cameras with a lens report the blobs in their picture, without distances. One camera of an eyebot is panned and
// tilted.
#include <Eigen/Geometry>
#include <type_traits>

#include "../sight.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"

namespace swarmanoid::mock {
namespace {

// joints of the mock robot
constexpr const char* kPan = "camera_pan";
constexpr const char* kTilt = "camera_tilt";

class MockEyebotPanTilt final : public MockDevice {
 public:
  MockEyebotPanTilt(const EyebotPanTilt& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double dt) override {
    EyebotPanTilt wanted = command_;
    limitToRanges(wanted);
    Joint& pan = state.joints[kPan];
    Joint& tilt = state.joints[kTilt];
    pan.turn(wanted.pan - pan.angle, EyebotPanTilt::kPanSpeed, dt);
    tilt.turn(wanted.tilt - tilt.angle, EyebotPanTilt::kTiltSpeed, dt);
  }

 private:
  const EyebotPanTilt& command_;
};

template <class Camera>
class MockLensCamera final : public MockCamera<Camera> {
 public:
  using MockCamera<Camera>::MockCamera;

 protected:
  View view(const MockState& state) const override {
    Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
    if constexpr (std::is_same_v<Camera, EyebotPanTiltCamera>) {
      turned = Eigen::AngleAxisd(state.joint(kPan).angle, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(-state.joint(kTilt).angle, Eigen::Vector3d::UnitY());
    }
    const auto& [x, y, z] = Camera::kMount;
    return {
        {x, y, z},
        Camera::kUsualRange,
        [turned, picture = Picture()](const Eigen::Vector3d& way) { return picture.shows(turned.transpose() * way); },
        false};
  }
};

REGISTER_MOCK_DEVICE(EyebotPanTilt, MockEyebotPanTilt)
REGISTER_MOCK_DEVICE(EyebotPanTiltCamera, MockLensCamera<EyebotPanTiltCamera>)
REGISTER_MOCK_DEVICE(FootbotFrontCamera, MockLensCamera<FootbotFrontCamera>)
REGISTER_MOCK_DEVICE(HandbotCamera, MockLensCamera<HandbotCamera>)

}  // namespace
}  // namespace swarmanoid::mock
