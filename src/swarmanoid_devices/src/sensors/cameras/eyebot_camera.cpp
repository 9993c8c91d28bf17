// The eyebot's camera: its field of view is a cone below it, so its area on the ground grows with the height.
#include "color_blob_camera.hpp"
#include "unreliable_camera.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotCameraSensor : public ColorBlobCameraSensor<EyebotCamera, ConeView> {
 public:
  static PluginDescription describe() {
    PluginDescription description = describeCamera(numberText(EyebotCamera::kUsualRange), "true");
    description.summary = "Camera looking down that reports blobs of colour.";
    description.parameters.push_back(
        angle("aperture", "45", {1.0, 85.0}, "Half the opening angle of the cone that it sees."));
    return description;
  }

 protected:
  ConeView makeView(const Configuration& parameters) const override {
    return ConeView(parameters.angle("aperture", EyebotCamera::kUsualAperture));
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_CAMERA(swarmanoid::devices::EyebotCameraSensor)
