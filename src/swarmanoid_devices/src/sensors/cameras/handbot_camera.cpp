// The handbot's camera, in its head.
#include "lens_camera.hpp"
#include "unreliable_camera.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotCameraSensor : public LensCameraSensor<HandbotCamera> {
 public:
  static PluginDescription describe() {
    return describeLens("Camera in the head, looking ahead, that reports blobs of colour.", "false");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_CAMERA(swarmanoid::devices::HandbotCameraSensor)
