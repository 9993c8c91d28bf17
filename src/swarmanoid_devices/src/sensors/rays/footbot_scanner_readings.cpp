// The four beams of the rotating distance scanner. The head has no mass and no shape, so no engine moves it; its angle
// is computed from the actuations alone, tick by tick.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "common/parameters.hpp"
#include "common/sample_times.hpp"
#include "common/tick_guard.hpp"
#include "surroundings/color_blob_finder.hpp"
#include "surroundings/distance_rays.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

using Readings = FootbotScannerReadings;

struct ScannerInstance : BasicSensorInstance<Readings> {
  Mount mount;
  double before = 0.0;  // head angle in the tick before the last sensed one, rad
  double angle = 0.0;   // head angle in the last sensed tick, rad
  Pose pose_before;     // robot pose in the tick before the last sensed one
  Pose pose;            // robot pose in the last sensed tick
  TickGuard tick;

  void archive(StateArchive& state) { state(before, angle, pose_before, pose, tick); }
};

/// Samples of one tick, oldest first: angles of the head, and origins and directions of its beams.
struct Shots {
  std::size_t count = 0;
  std::array<double, Readings::kSamples> angle;             // of the head, in the robot's frame [rad]
  std::array<Eigen::Vector3d, Readings::kSamples> from;     // in W [m]
  std::array<Eigen::Vector3d, Readings::kSamples> forward;  // direction of beam 0, in W
  std::array<Eigen::Vector3d, Readings::kSamples> left;     // direction of beam 1, in W
  double slope = 0.0;                                       // steepest slope in the plane of the beams
  Eigen::Vector3d centre;                                   // of a sphere that contains `from` [m]
  double radius = 0.0;
};

class FootbotScannerSensor final : public SensorOf<Readings, ScannerInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Readings::kType;
    description.implementation = "rays";
    description.is_default = true;
    description.summary = "Two short and two long infrared beams on the head; distance straight ahead.";
    description.parameters = {
        number("rate", "1/s", "0", {0.0, 10000.0},
               "Samples of each beam in a second, from where the robot was then; 0: 8 in each tick."),
        tooCloseParameter()};
    return description;
  }

  void configure(const Configuration& parameters) override {
    rate_ = parameters.number("rate", 0.0);
    folds_ = parameters.text("too_close", kReported) == kFolded;
  }

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

  /// Draws the samples of the tick at the distances read, from the current position of the head, except those too
  /// close.
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
  void senseOne(const Space& space, double dt, ScannerInstance& instance) const {
    static const FootbotScanner kOff;
    const auto* actuation = space.actuation.find<FootbotScanner>(instance.row);
    const FootbotScanner& scanner = actuation == nullptr ? kOff : *actuation;
    const bool is_added = !instance.tick.hasBegun();
    if (instance.tick.begins(space.tick)) {
      instance.before = instance.angle;
      instance.pose_before = instance.pose;
    }
    instance.pose = space.entities.pose[instance.row];
    if (is_added || space.placed[instance.row] == space.tick) {
      instance.pose_before = instance.pose;  // a new or teleported robot has not moved here
    }
    const double turn = scanner.turnFrom(instance.before, dt);
    instance.angle = wrapTurn(instance.before + turn);
    const Shots shots = rate_ == 0.0 ? evenShots(instance, turn) : timedShots(space, instance, turn);
    Readings& readings = *instance.readings;
    readings.angle = instance.angle;
    readings.period = static_cast<float>(dt);
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      readings.angles[i] = toBearing(i < shots.count ? shots.angle[i] : instance.angle);
    }
    fill(readings, std::numeric_limits<float>::quiet_NaN());
    if (scanner.mode != FootbotScanner::Mode::kOff && shots.count > 0) {
      // short and long beams separately: short ones mostly have nothing in reach, which is found early
      measurePair(space, instance, 0, shots, shots.forward);
      measurePair(space, instance, 1, shots, shots.left);
    }
  }

  static void fill(Readings& readings, float distance) {
    for (std::size_t beam = 0; beam < Readings::kBeams; ++beam) {
      readings.distances(beam).fill(distance);
    }
  }

  /// Adds a sample. @param pose of the robot @param angle of the head
  static void addShot(const ScannerInstance& instance, const Pose& pose, double angle, Shots& shots) {
    const Eigen::Matrix3d head = (pose.orientation * instance.mount.orientation).toRotationMatrix();
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const std::size_t i = shots.count++;
    shots.angle[i] = angle;
    shots.from[i] = pose.toWorld(instance.mount.position);
    shots.forward[i] = head.col(0) * cosine + head.col(1) * sine;
    shots.left[i] = head.col(1) * cosine - head.col(0) * sine;
    shots.slope = std::max(shots.slope, head.row(2).head<2>().norm());
  }

  /// Samples spaced evenly over the tick, all from the current pose of the robot.
  static Shots evenShots(const ScannerInstance& instance, double turn) {
    Shots shots;
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      addShot(instance, instance.pose, Readings::angleOf(i, instance.before, turn), shots);
    }
    shots.centre = shots.from[0];
    return shots;
  }

  /// Samples at the whole multiples of 1 / rate within the tick, from interpolated poses of the robot.
  Shots timedShots(const Space& space, const ScannerInstance& instance, double turn) const {
    const std::int64_t end = samplesUntil(space.time, rate_);
    const std::int64_t begin = samplesUntil(space.time - space.clocktick, rate_);
    constexpr auto kMost = static_cast<std::int64_t>(Readings::kSamples);
    const double tick_end = toSeconds(space.time);
    const double dt = toSeconds(space.clocktick);
    const Pose& before = instance.pose_before;
    const Pose& now = instance.pose;
    Shots shots;
    for (std::int64_t k = std::max(begin, end - kMost) + 1; k <= end; ++k) {
      const double part = std::clamp(1.0 - (tick_end - static_cast<double>(k) / rate_) / dt, 0.0, 1.0);
      const Pose pose{before.position + part * (now.position - before.position),
                      before.orientation.slerp(part, now.orientation)};
      addShot(instance, pose, instance.before + part * turn, shots);
    }
    const Eigen::Vector3d first = before.toWorld(instance.mount.position);
    const Eigen::Vector3d last = now.toWorld(instance.mount.position);
    shots.centre = 0.5 * (first + last);
    constexpr double kMargin = 0.01;  // m: the head of a turning robot may leave the straight line
    shots.radius = 0.5 * (last - first).norm() + kMargin;
    return shots;
  }

  /// Measures with a beam and the opposite one. @param directions of the first beam, by sample
  void measurePair(const Space& space, ScannerInstance& instance, std::size_t first_beam, const Shots& shots,
                   const std::array<Eigen::Vector3d, Readings::kSamples>& directions) const {
    const Range range = Readings::rangeOf(first_beam);
    Readings::Samples& one = instance.readings->distances(first_beam);
    Readings::Samples& other = instance.readings->distances(first_beam + 2);
    const std::size_t count = shots.count;
    RayBundle rays;
    rays.centre = shots.centre;
    rays.radius = shots.radius + range.maximum;
    rays.ignored = instance.row;
    if (!mayMeasure(space, rays, shots.centre.z() - shots.radius - range.maximum * shots.slope)) {
      std::fill_n(one.begin(), count, std::numeric_limits<float>::infinity());
      std::fill_n(other.begin(), count, std::numeric_limits<float>::infinity());
      return;
    }
    constexpr std::size_t kRays = 2 * Readings::kSamples;
    std::array<Segment, kRays> segments;
    std::array<RayHit, kRays> hits;
    for (std::size_t i = 0; i < count; ++i) {
      segments[i] = {shots.from[i], shots.from[i] + range.maximum * directions[i]};
      segments[count + i] = {shots.from[i], shots.from[i] + range.maximum * -directions[i]};
    }
    rays.segments = Span<const Segment>(segments.data(), 2 * count);
    castDistances(space, rays, Span<RayHit>(hits.data(), 2 * count));
    for (std::size_t k = 0; k < 2 * count; ++k) {
      const double distance = hits[k].isHit() ? hits[k].fraction * range.maximum : kInfinity;
      (k < count ? one : other)[k % count] =
          folds_ ? Distance::foldedReading(distance, range) : Distance::reading(distance, range);
    }
  }

  double rate_ = 0.0;   // samples of each beam in a second; 0: Readings::kSamples in each tick
  bool folds_ = false;  // whether targets that are too close read as farther ones
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotScannerSensor)
