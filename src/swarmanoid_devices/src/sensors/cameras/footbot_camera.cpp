// The footbot's omnidirectional camera: its field of view covers all directions, up to the range of the mirror.
#include "color_blob_camera.hpp"
#include "unreliable_camera.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotCameraSensor : public ColorBlobCameraSensor<FootbotCamera, RingView> {
 public:
  static PluginDescription describe() {
    PluginDescription description = describeCamera(numberText(FootbotCamera::kUsualRange), "false");
    description.label_aliases = {"pie_camera"};
    description.implementation_aliases = {"generic_pie_camera"};
    description.summary = "Omnidirectional camera that reports blobs of colour.";
    return description;
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_CAMERA(swarmanoid::devices::FootbotCameraSensor)
