// The lidar of any robot: beams in the plane of the link `lidar`, all at one moment.
//
// Space casts at most 64 rays at once, so a scan is cast in sectors of that many beams. Each sector searches for solids
// in its own sphere, which is much smaller than that of the whole scan.
#include "swarmanoid_interface/devices/lidar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "common/mechanisms.hpp"
#include "common/parameters.hpp"
#include "common/sample_times.hpp"
#include "common/span_readings.hpp"
#include "surroundings/distance_rays.hpp"
#include "swarmanoid_space/device_drawing.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct LidarInstance : SpanReadings<BasicSensorInstance<Lidar>, LidarBeam> {
  Mount mount;
  std::optional<Time> scanned;  // time of the last scan; empty for a new robot

  void archive(StateArchive& state) {
    SpanReadings::archive(state);
    state(scanned);
  }
};

constexpr std::size_t kSectorBeams = 8 * sizeof(RayMask);  // maximum number of rays in a bundle

/// Consecutive beams that are cast together, and the smallest sphere that contains them.
struct Sector {
  std::size_t begin = 0;
  std::size_t count = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // of the sphere, in the plane of the beams [m]
  double radius = 0.0;                               // of the sphere [m]
};

Eigen::Vector2d unitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// @param first angle of its first beam [rad] @param width angle from there to its last beam [rad]
/// @param reach length of the beams [m]
Sector makeSector(std::size_t begin, std::size_t count, double first, double width, double reach) {
  const double half = 0.5 * width;
  double along = 0.0;  // distance from the mount to the centre
  double radius = reach;
  if (half < M_PI / 4.0) {  // through the mount and both ends
    along = radius = 0.5 * reach / std::cos(half);
  } else if (half < M_PI / 2.0) {  // around the chord between the ends
    along = reach * std::cos(half);
    radius = reach * std::sin(half);
  }
  constexpr double kMargin = 1e-9;  // as a fraction of the radius, for rounding
  return {begin, count, along * unitVector(first + half), (1.0 + kMargin) * radius};
}

class LidarSensor final : public SensorOf<Lidar, LidarInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = Lidar::kType;
    description.implementation = "rays";
    description.is_default = true;
    description.summary = "Laser beams in a plane; distance to the first hit of each.";
    const Range any{0.0, Lidar::kFarthest};
    description.parameters = {
        integer("beams", std::to_string(Lidar::kUsualBeams), {1.0, static_cast<double>(Lidar::kMostBeams)},
                "Beams, evenly over the field of view."),
        angle("field_of_view", "360", {0.0, 360.0}, "Angle from the first beam to the last, symmetric about ahead."),
        number("range_min", "m", numberText(Lidar::kUsualRange.minimum), any,
               "Minimum range; nearer objects are too close."),
        number("range_max", "m", numberText(Lidar::kUsualRange.maximum), any, "Maximum range."),
        number("noise", "m", "0", {0.0, 10.0}, "Standard deviation added to each distance."),
        number("rate", "1/s", "0", {0.0, 10000.0}, "Scans in a second, at most one a tick; 0: one in each tick.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    range_ = {parameters.number("range_min"), parameters.number("range_max")};
    refuseEmptyRange(range_, parameters);
    noise_ = parameters.number("noise");
    rate_ = parameters.number("rate");
    arrangeBeams(static_cast<std::size_t>(parameters.integer("beams")), parameters.angle("field_of_view", 2.0 * M_PI));
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    const bool is_due =
        rate_ == 0.0 || samplesUntil(space.time, rate_) > samplesUntil(space.time - space.clocktick, rate_);
    for (std::size_t k = first; k < last; ++k) {
      LidarInstance& instance = instances_[k];
      // a tick that is sensed again repeats its scan
      if (is_due || !instance.scanned || *instance.scanned == space.time) {
        scan(space, instance);
        instance.scanned = space.time;
      }
      instance.readings->age = toSeconds(space.time - *instance.scanned);
    }
  }

 protected:
  std::size_t mostElements() const override { return directions_.size(); }

  void prepareInstance(const Space& space, LidarInstance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    const auto link = model.mounts.find(Lidar::kLink);
    if (link == model.mounts.end() || link->second.joint >= 0) {
      refuseWithout(Lidar::kType, model, "a link " + std::string(Lidar::kLink) + " that no joint turns");
    }
    instance.mount = link->second;
    instance.readings->beams = instance.makeRoom(directions_.size());
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      instance.buffer[i].angle = static_cast<float>(angles_[i]);
    }
    instance.readings->range_min = static_cast<float>(range_.minimum);
    instance.readings->range_max = static_cast<float>(range_.maximum);
    instance.readings->scan_time =
        static_cast<float>(std::max(toSeconds(space.clocktick), rate_ == 0.0 ? 0.0 : 1.0 / rate_));
  }

  /// Draws the beams up to their hits, from the current pose of the robot, except readings that are too close.
  void drawOne(const Space& space, const LidarInstance& instance, DeviceDrawing& drawing) const override {
    const Eigen::Isometry3d plane = planeOf(space, instance);
    const Lidar& readings = delivered(instance);
    for (std::size_t i = 0; i < readings.beams.size(); ++i) {
      const auto range = static_cast<double>(readings.beams[i].range);
      if (!(range >= 0.0)) {  // too close, or not measured
        continue;
      }
      const double way = std::min(range, range_.maximum);
      const Eigen::Vector3d end = plane * inPlane(way * directions_[i]);
      const Color shade = DeviceDrawing::shade(1.0 - way / range_.maximum);
      drawing.line(plane.translation(), end, shade);
      if (range <= range_.maximum) {
        drawing.point(end, shade);
      }
    }
  }

 private:
  static Eigen::Vector3d inPlane(const Eigen::Vector2d& point) { return {point.x(), point.y(), 0.0}; }

  /// Transform from the frame of the link to W.
  static Eigen::Isometry3d planeOf(const Space& space, const LidarInstance& instance) {
    const Pose& pose = space.entities.pose[instance.row];
    Eigen::Isometry3d plane = Eigen::Isometry3d::Identity();
    plane.translation() = pose.toWorld(instance.mount.position);
    plane.linear() = (pose.orientation * instance.mount.orientation).toRotationMatrix();
    return plane;
  }

  void arrangeBeams(std::size_t beams, double field_of_view) {
    const double first = Lidar::firstAngle(beams, field_of_view);
    const double increment = Lidar::increment(beams, field_of_view);
    for (std::size_t i = 0; i < beams; ++i) {
      angles_.push_back(first + static_cast<double>(i) * increment);
      directions_.push_back(unitVector(angles_.back()));
    }
    for (std::size_t begin = 0; begin < beams; begin += kSectorBeams) {
      const std::size_t count = std::min(kSectorBeams, beams - begin);
      sectors_.push_back(
          makeSector(begin, count, angles_[begin], angles_[begin + count - 1] - angles_[begin], range_.maximum));
    }
  }

  void scan(const Space& space, LidarInstance& instance) const {
    const Eigen::Isometry3d plane = planeOf(space, instance);
    instance.random.startTick(space.tick);
    for (const Sector& sector : sectors_) {
      scanSector(space, plane, sector, instance);
    }
  }

  void scanSector(const Space& space, const Eigen::Isometry3d& plane, const Sector& sector,
                  LidarInstance& instance) const {
    std::array<Segment, kSectorBeams> segments;
    std::array<RayHit, kSectorBeams> hits;
    double lowest = plane.translation().z();
    for (std::size_t i = 0; i < sector.count; ++i) {
      segments[i] = {plane.translation(), plane * inPlane(range_.maximum * directions_[sector.begin + i])};
      lowest = std::min(lowest, segments[i].to.z());
    }
    RayBundle rays;
    rays.segments = Span<const Segment>(segments.data(), sector.count);
    rays.centre = plane * inPlane(sector.centre);
    rays.radius = sector.radius;
    rays.ignored = instance.row;
    const bool may_measure = mayMeasure(space, rays, lowest);
    if (may_measure) {
      castDistances(space, rays, Span<RayHit>(hits.data(), sector.count));
    }
    for (std::size_t i = 0; i < sector.count; ++i) {
      const bool is_hit = may_measure && hits[i].isHit();
      instance.buffer[sector.begin + i].range =
          measured(is_hit ? hits[i].fraction * range_.maximum : kInfinity, instance);
    }
  }

  /// @param way distance to the hit, or infinity [m]
  float measured(double way, LidarInstance& instance) const {
    const float exact = Distance::reading(way, range_);
    return noise_ > 0.0 && std::isfinite(exact) ? Distance::reading(way + instance.random.gaussian(0.0, noise_), range_)
                                                : exact;
  }

  Range range_;                              // measuring range, m
  double noise_ = 0.0;                       // standard deviation, m
  double rate_ = 0.0;                        // scans in a second; 0: one in each tick
  std::vector<double> angles_;               // of the beams in the plane [rad]
  std::vector<Eigen::Vector2d> directions_;  // the same as unit vectors
  std::vector<Sector> sectors_;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::LidarSensor)
