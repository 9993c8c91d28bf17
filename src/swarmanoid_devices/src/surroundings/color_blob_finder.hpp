/// Finds the blobs that a colour-blob camera sees: lit LEDs and lamps, coloured preys, laser spots and floor patches,
/// unless another entity or the robot that carries the LED (LedShades) hides them. All cameras share it; they differ in
/// their FieldOfView.
#pragma once

#include <cstddef>
#include <vector>

#include "common/field_of_view.hpp"
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
  /// Returns the LEDs of `asked` that are in view.
  LedSet inView(const LedPoints& points, const LedSet& asked) const;
};

/// A point that gives a blob.
struct Sighting {
  Color color;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();  ///< from the camera to the point, in W [m]
  float distance = 0.0F;                          ///< horizontal length of `way` [m]
  double radius = 0.0;                            ///< of the blob [m]
  std::size_t place = 0;                          ///< rank in the order defined by ColorBlobs
};

/// @param point in W @param radius of the blob [m]
Sighting sightingOf(const Eye& eye, const Eigen::Vector3d& point, Color color, double radius, std::size_t place);

/// Converts sightings to the blobs that the camera reports. @param knows_distance false: distances are NaN
/// @param blobs output, of the same size as `sightings`
void toBlobs(const std::vector<Sighting>& sightings, const Eye& eye, bool knows_distance, Span<ColorBlob> blobs);

/// Collects all sightings, in the order defined by ColorBlobs. Thread-safe.
void lookAround(const Space& space, const BlobView& view, std::vector<Sighting>& found);

}  // namespace swarmanoid::devices
