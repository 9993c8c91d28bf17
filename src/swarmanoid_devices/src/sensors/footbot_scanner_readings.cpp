// The four beams of the rotating distance scanner. The head has no mass and no shape, so no engine moves it: its angle
// follows from the actuations alone, tick by tick.
#include <algorithm>
#include <array>
#include <cmath>

#include "color_blob_finder.hpp"
#include "distance_rays.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "tick_guard.hpp"

namespace swarmanoid::devices {
namespace {

using Readings = FootbotScannerReadings;

struct ScannerInstance : BasicSensorInstance<Readings> {
  Mount mount;
  double before = 0.0;  // angle of the head in the tick before the last one that was sensed, rad
  double angle = 0.0;   // in that
  TickGuard tick;
};

class FootbotScannerSensor final : public SensorOf<Readings, ScannerInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Readings::kType;
    description.implementation = "rays";
    description.is_default = true;
    description.summary = "Two short and two long infrared beams on the head; the way to what is straight ahead.";
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
  void prepareInstance(const Space& space, ScannerInstance& instance) override {
    instance.mount = space.entities.model[instance.row]->mount("scanner");
  }

  /// The samples of the tick, from where the head is now, as long as they are read; what is too close is not drawn.
  void drawOne(const Space& space, const ScannerInstance& instance, DeviceDrawing& drawing) const override {
    const Readings& readings = delivered(instance);
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Vector3d centre = pose.toWorld(instance.mount.position);
    const Eigen::Matrix3d head = (pose.orientation * instance.mount.orientation).toRotationMatrix();
    for (std::size_t beam = 0; beam < Readings::kBeams; ++beam) {
      const double range = Readings::rangeOf(beam).maximum;
      for (std::size_t i = 0; i < Readings::kSamples; ++i) {
        const auto distance = static_cast<double>(readings.distances(beam)[i]);
        if (!(distance >= 0.0)) {  // too close, or not measured
          continue;
        }
        const double angle = static_cast<double>(readings.angles[i]) + Readings::offset(beam);
        const Eigen::Vector3d direction = head.col(0) * std::cos(angle) + head.col(1) * std::sin(angle);
        const double way = std::min(distance, range);
        const Color shade = DeviceDrawing::shade(1.0 - way / range);
        drawing.line(centre, centre + way * direction, shade);
        if (distance <= range) {
          drawing.point(centre + way * direction, shade);
        }
      }
    }
  }

 private:
  static void senseOne(const Space& space, double dt, ScannerInstance& instance) {
    static const FootbotScanner kOff;
    const auto* actuation = space.actuation.find<FootbotScanner>(instance.row);
    const FootbotScanner& scanner = actuation == nullptr ? kOff : *actuation;
    if (instance.tick.begins(space.tick)) {
      instance.before = instance.angle;
    }
    const double turn = scanner.turnFrom(instance.before, dt);
    instance.angle = wrapTurn(instance.before + turn);
    Readings& readings = *instance.readings;
    readings.angle = instance.angle;
    readings.period = static_cast<float>(dt);
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      readings.angles[i] = toBearing(Readings::angleOf(i, instance.before, turn));
    }
    if (scanner.mode == FootbotScanner::Mode::kOff) {
      fill(readings, std::numeric_limits<float>::quiet_NaN());
    } else {
      measure(space, instance, turn);
    }
  }

  static void fill(Readings& readings, float distance) {
    for (std::size_t beam = 0; beam < Readings::kBeams; ++beam) {
      readings.distances(beam).fill(distance);
    }
  }

  /// The short beams and the long ones apart: short ones mostly have nothing in reach, which is found at once.
  static void measure(const Space& space, ScannerInstance& instance, double turn) {
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Vector3d centre = pose.toWorld(instance.mount.position);
    const Eigen::Matrix3d head = (pose.orientation * instance.mount.orientation).toRotationMatrix();
    std::array<Eigen::Vector3d, Readings::kSamples> ahead;  // where beam 0 looked
    std::array<Eigen::Vector3d, Readings::kSamples> left;   // where beam 1 looked
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      const double angle = Readings::angleOf(i, instance.before, turn);
      const double cosine = std::cos(angle);
      const double sine = std::sin(angle);
      ahead[i] = head.col(0) * cosine + head.col(1) * sine;
      left[i] = head.col(1) * cosine - head.col(0) * sine;
    }
    const double slope = head.row(2).head<2>().norm();  // of the steepest way down in the plane of the beams
    measurePair(space, instance, 0, centre, ahead, slope);
    measurePair(space, instance, 1, centre, left, slope);
  }

  /// A beam and the opposite one. @param directions of the first, sample by sample
  static void measurePair(const Space& space, ScannerInstance& instance, std::size_t first_beam,
                          const Eigen::Vector3d& centre,
                          const std::array<Eigen::Vector3d, Readings::kSamples>& directions, double slope) {
    constexpr std::size_t kRays = 2 * Readings::kSamples;
    const Range range = Readings::rangeOf(first_beam);
    Readings::Samples& one = instance.readings->distances(first_beam);
    Readings::Samples& other = instance.readings->distances(first_beam + 2);
    RayBundle rays;
    rays.centre = centre;
    rays.radius = range.maximum;
    rays.ignored = instance.row;
    if (!mayMeasure(space, rays, centre.z() - rays.radius * slope)) {
      one.fill(std::numeric_limits<float>::infinity());
      other.fill(std::numeric_limits<float>::infinity());
      return;
    }
    std::array<Segment, kRays> segments;
    std::array<RayHit, kRays> hits;
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      segments[i] = {centre, centre + range.maximum * directions[i]};
      segments[Readings::kSamples + i] = {centre, centre + range.maximum * -directions[i]};
    }
    rays.segments = Span<const Segment>(segments.data(), kRays);
    castDistances(space, rays, Span<RayHit>(hits.data(), kRays));
    for (std::size_t k = 0; k < kRays; ++k) {
      const double distance = hits[k].isHit() ? hits[k].fraction * range.maximum : kInfinity;
      (k < Readings::kSamples ? one : other)[k % Readings::kSamples] = Distance::reading(distance, range);
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotScannerSensor)
