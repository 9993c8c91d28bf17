/// Selects the blobs of one colour from a camera's readings.
#pragma once

#include <cmath>
#include <optional>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid {

/// A point on the ground in the robot's frame.
struct Sighting {
  double x = 0.0;  ///< ahead [m]
  double y = 0.0;  ///< left [m]

  double distance() const { return std::hypot(x, y); }
  double bearing() const { return std::atan2(y, x); }
  double distanceTo(const Sighting& other) const { return std::hypot(x - other.x, y - other.y); }
};

inline Sighting sightingOf(const ColorBlob& blob) {
  return {blob.distance * std::cos(static_cast<double>(blob.bearing)),
          blob.distance * std::sin(static_cast<double>(blob.bearing))};
}

/// Returns the nearest blob of a colour.
inline std::optional<Sighting> nearestBlob(const ColorBlobs& seen, Color color) {
  const ColorBlob* nearest = nullptr;
  for (const ColorBlob& blob : seen.blobs) {
    if (blob.color == color && (nearest == nullptr || blob.distance < nearest->distance)) {
      nearest = &blob;
    }
  }
  return nearest == nullptr ? std::nullopt : std::optional<Sighting>(sightingOf(*nearest));
}

/// Returns the mean position of all blobs of a colour, such as of a ring of LEDs seen from above.
inline std::optional<Sighting> middleOfBlobs(const ColorBlobs& seen, Color color) {
  Sighting sum;
  int count = 0;
  for (const ColorBlob& blob : seen.blobs) {
    if (blob.color == color) {
      const Sighting sighting = sightingOf(blob);
      sum.x += sighting.x;
      sum.y += sighting.y;
      ++count;
    }
  }
  return count == 0 ? std::nullopt : std::optional<Sighting>(Sighting{sum.x / count, sum.y / count});
}

}  // namespace swarmanoid
