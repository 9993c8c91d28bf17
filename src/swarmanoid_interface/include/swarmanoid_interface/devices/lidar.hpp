/// Sensor: a lidar (laser scanner) of any robot, any number of beams from one mount.
///
/// Frame: the link `lidar` of the robot's description. Beams lie in its x-y plane and start at its origin; angles are
/// counter-clockwise about its z axis, 0 is along its x axis, as in sensor_msgs/LaserScan.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The reading of one beam.
struct LidarBeam {
  /// [m]; by REP-117 infinity with nothing in range, -infinity with an object too close, NaN before the first scan
  float range = std::numeric_limits<float>::quiet_NaN();
  float angle = 0.0F;  ///< direction of the beam in the frame of the link [rad], in [-pi, pi]
};

/// The last scan: all beams at one moment, in order of increasing angle. The span is valid until the next tick.
struct Lidar {
  static constexpr const char* kType = "lidar";
  static constexpr const char* kLink = "lidar";
  static constexpr std::size_t kMostBeams = 4096;
  static constexpr double kFarthest = 100.0;  ///< largest range that an experiment may set [m]
  /// Defaults, those of an LDS-01 of ROBOTIS: 360 beams around, 0.12 to 3.5 m (its e-manual).
  static constexpr std::size_t kUsualBeams = 360;
  static constexpr Range kUsualRange{0.12, 3.5};

  Span<const LidarBeam> beams;
  float range_min = static_cast<float>(kUsualRange.minimum);  ///< nearer objects are too close [m]
  float range_max = static_cast<float>(kUsualRange.maximum);  ///< farther objects are out of range [m]
  float scan_time = 0.0F;                                     ///< period of the scans [s]
  double age = 0.0;                                           ///< age of the scan; 0 in the tick of the scan [s]

  /// Angle between neighbouring beams [rad]. A field of view of a whole turn is divided evenly, so that the last beam
  /// is not the first one again; a smaller one has a beam at each end. @pre beams > 0
  static double increment(std::size_t beams, double field_of_view) {
    constexpr double kRounding = 1e-9;
    const bool is_turn = field_of_view > 2.0 * M_PI - kRounding;
    return beams == 1 ? 0.0 : field_of_view / static_cast<double>(is_turn ? beams : beams - 1);
  }
  /// Angle of the first beam [rad]; a single beam looks along x.
  static double firstAngle(std::size_t beams, double field_of_view) { return beams == 1 ? 0.0 : -0.5 * field_of_view; }
};

/// Age of the readings [s], for messages with a stamp.
inline double ageOf(const Lidar& lidar) { return lidar.age; }

template <class Visitor>
void fields(Visitor& visit, LidarBeam& beam) {
  visit(beam.range, distanceField("range", kDistanceMeaning, {0.0, Lidar::kFarthest}));
  visit(beam.angle, {"angle", "rad", "where the beam looks in the frame of the link `lidar`", {-M_PI, M_PI}});
}
template <class Visitor>
void fields(Visitor& visit, Lidar& lidar) {
  visit(lidar.beams, {"beams"});
  visit(lidar.range_min, {"range_min", "m", "minimum range: nearer objects are too close", {0.0, Lidar::kFarthest}});
  visit(lidar.range_max,
        {"range_max", "m", "maximum range: farther objects are out of range", {0.0, Lidar::kFarthest}});
  visit(lidar.scan_time, {"scan_time", "s", "from one scan to the next"});
  visit(lidar.age, {"age", "s", "of the scan; 0 in the tick in which it is new"});
}
REGISTER_DEVICE_OF_SUITE(Lidar, kSensor, "A lidar, any number of beams from one mount.")

}  // namespace swarmanoid
