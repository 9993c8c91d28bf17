// The pan-tilt mount of the eyebot's camera: it turns to the commanded angles at limited speeds. Engines ignore its
// mass, so this device keeps its angles.
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"

#include "common/parameters.hpp"
#include "common/tick_guard.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

/// With the current angles, and those of the previous tick.
struct PanTiltInstance : BasicActuatorInstance<EyebotPanTilt> {
  double pan = 0.0;          // rad
  double tilt = 0.0;         // rad
  double pan_before = 0.0;   // rad
  double tilt_before = 0.0;  // rad
  TickGuard tick;

  void archive(StateArchive& state) { state(pan, tilt, pan_before, tilt_before, tick); }
};

class EyebotPanTiltActuator final : public ActuatorOf<EyebotPanTilt, PanTiltInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotPanTilt::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Pans and tilts a camera, each with a greatest speed.";
    description.parameters = {
        number("pan_speed", "rad/s", numberText(EyebotPanTilt::kPanSpeed), {0.001, 100.0}, "The greatest of the pan."),
        number("tilt_speed", "rad/s", numberText(EyebotPanTilt::kTiltSpeed), {0.001, 100.0},
               "The greatest of the tilt.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    pan_speed_ = parameters.number("pan_speed", EyebotPanTilt::kPanSpeed);
    tilt_speed_ = parameters.number("tilt_speed", EyebotPanTilt::kTiltSpeed);
  }

 protected:
  void limit(const Space& space, PanTiltInstance& instance) override {
    EyebotPanTilt& mounting = *instance.actuation;
    limitToRanges(mounting);
    if (instance.tick.begins(space.tick)) {
      instance.pan_before = instance.pan;
      instance.tilt_before = instance.tilt;
    }
    const double dt = toSeconds(space.clocktick);
    instance.pan = mounting.pan = EyebotPanTilt::turned(instance.pan_before, mounting.pan, pan_speed_, dt);
    instance.tilt = mounting.tilt = EyebotPanTilt::turned(instance.tilt_before, mounting.tilt, tilt_speed_, dt);
  }

 private:
  double pan_speed_ = EyebotPanTilt::kPanSpeed;
  double tilt_speed_ = EyebotPanTilt::kTiltSpeed;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotPanTiltActuator)
