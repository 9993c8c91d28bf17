// The inertial measurement unit of any robot, from the velocities at the ends of the last two ticks.
#include "swarmanoid_interface/devices/imu.hpp"

#include "common/tick_guard.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct ImuInstance : BasicSensorInstance<Imu> {
  Imu::Motion before;  // at the end of the tick before the last sensed one
  Imu::Motion last;    // at the end of the last sensed tick
  TickGuard tick;

  void archive(StateArchive& state) { state(before, last, tick); }
};

class ImuSensor final : public SensorOf<Imu, ImuInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Imu::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Gyroscopes and accelerometers at the robot's origin.";
    return description;
  }

  void configure(const Configuration&) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    const double dt = toSeconds(space.clocktick);
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, dt, instances_[k]);
    }
  }

 protected:
  /// Draws the reading of the accelerometers, 2 cm for each m/s2, from the top of the robot above its origin.
  void drawOne(const Space& space, const ImuInstance& instance, DeviceDrawing& drawing) const override {
    constexpr double kScale = 0.02;  // m per m/s2
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Vector3d top(0.0, 0.0, space.entities.model[instance.row]->highest);
    drawing.arrow(pose.toWorld(top), pose.toWorld(top + kScale * delivered(instance).linear_acceleration),
                  colors::kGreen);
  }

 private:
  static void senseOne(const Space& space, double dt, ImuInstance& instance) {
    const Eigen::Quaterniond to_body = space.entities.pose[instance.row].orientation.conjugate();
    const Twist& twist = space.entities.twist[instance.row];
    const Engine* engine = space.mover[instance.row];
    const Imu::Motion now{to_body * twist.linear, to_body * twist.angular, to_body * Eigen::Vector3d::UnitZ(),
                          engine == nullptr ? Engine::kUsualGravity : engine->gravity()};
    const bool is_added = !instance.tick.hasBegun();
    if (instance.tick.begins(space.tick)) {
      instance.before = instance.last;
    }
    if (is_added || space.placed[instance.row] == space.tick) {
      instance.before = now;  // a new robot has no previous motion; a teleport is no acceleration
    }
    instance.last = now;
    *instance.readings = Imu::reading(instance.before, now, dt);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::ImuSensor)
