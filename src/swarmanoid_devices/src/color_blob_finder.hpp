/// Finds the blobs that a colour-blob camera has in sight: lit LEDs and lamps, coloured preys, laser spots and floor
/// patches, unless another entity or the robot that carries the LED (LedShades) is in between. All cameras share it;
/// they differ in their FieldOfView.
#pragma once

#include <cstddef>
#include <vector>

#include "field_of_view.hpp"
#include "near_obstacles.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Converts an angle to the form of ColorBlob, in (-pi, pi] [rad].
float toBearing(double angle);

/// One camera of one robot, at this tick.
struct BlobView {
  Row self = kNoRow;
  Eye eye;
  double range = 0.0;                  ///< maximum horizontal distance of a blob [m]
  const FieldOfView* field = nullptr;  ///< not null
  bool sees_floor = false;

  bool inView(const Eigen::Vector3d& point) const;
  /// Returns those of the LEDs asked about that are in view.
  LedSet inView(const LedPoints& points, const LedSet& asked) const;
};

/// What gives a blob.
struct Sighting {
  Color color;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();  ///< from the camera, in W [m]
  float distance = 0.0F;                          ///< the horizontal length of the way [m]
  double radius = 0.0;                            ///< of what is seen [m]
  std::size_t place = 0;                          ///< rank in the order defined by ColorBlobs
};

/// @param point in W @param radius of what is there [m]
Sighting sightingOf(const Eye& eye, const Eigen::Vector3d& point, Color color, double radius, std::size_t place);

/// What the camera reports of all that is in sight. @param knows_distance or distances are NaN
/// @param blobs as many as sightings, to be filled
void toBlobs(const std::vector<Sighting>& sightings, const Eye& eye, bool knows_distance, Span<ColorBlob> blobs);

/// Writes all that is in sight, in the order defined by ColorBlobs. Thread-safe.
void lookAround(const Space& space, const BlobView& view, std::vector<Sighting>& found);

}  // namespace swarmanoid::devices
