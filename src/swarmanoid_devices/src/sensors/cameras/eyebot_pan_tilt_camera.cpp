// The eyebot's pan-tilt camera. Without the pan-tilt actuator it looks ahead.
#include "lens_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"
#include "unreliable_camera.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotPanTiltCameraSensor : public LensCameraSensor<EyebotPanTiltCamera> {
 public:
  static PluginDescription describe() {
    return describeLens("Camera on a mounting that pans and tilts it; reports blobs of colour.", "true");
  }

 protected:
  const char* link() const override { return "pan_tilt_camera"; }

  Eigen::Quaterniond orientationOf(const Space& space, const Instance& instance) const override {
    // the actuation holds the current angles of the mount
    const auto* mounting = space.actuation.find<EyebotPanTilt>(instance.row);
    const EyebotPanTilt turned = mounting == nullptr ? EyebotPanTilt() : *mounting;
    return instance.mount.orientation * Eigen::AngleAxisd(turned.pan, Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(-turned.tilt, Eigen::Vector3d::UnitY());
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_CAMERA(swarmanoid::devices::EyebotPanTiltCameraSensor)
