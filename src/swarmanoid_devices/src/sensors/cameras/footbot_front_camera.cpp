// The footbot's camera that looks ahead.
#include "lens_camera.hpp"
#include "unreliable_camera.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotFrontCameraSensor : public LensCameraSensor<FootbotFrontCamera> {
 public:
  static PluginDescription describe() {
    return describeLens("Camera looking ahead that reports blobs of colour.", "false");
  }

 protected:
  const char* link() const override { return "front_camera"; }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_CAMERA(swarmanoid::devices::FootbotFrontCameraSensor)
