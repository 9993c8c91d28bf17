// The eyebot's omnidirectional camera, on its mast.
#include "color_blob_camera.hpp"
#include "unreliable_camera.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotOmnidirectionalCameraSensor : public ColorBlobCameraSensor<EyebotOmnidirectionalCamera, RingView> {
 public:
  static PluginDescription describe() {
    PluginDescription description = describeCamera(numberText(EyebotOmnidirectionalCamera::kUsualRange), "false");
    description.summary = "Camera that sees all around at any height and reports blobs of colour.";
    return description;
  }

 protected:
  const char* link() const override { return "omnidirectional_camera"; }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_CAMERA(swarmanoid::devices::EyebotOmnidirectionalCameraSensor)
