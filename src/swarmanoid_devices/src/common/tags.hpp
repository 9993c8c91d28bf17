/// The radio tags around an antenna: all entities with the properties kTag and kTagData. Readers and writers share it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "parameters.hpp"
#include "surroundings/transmitters.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Converts a number of a tag to uint32. A package's property may be out of its range; it is clamped, and a fraction is
/// dropped.
inline std::uint32_t tagNumber(double value) {
  return static_cast<std::uint32_t>(std::clamp(value, 0.0, 4294967295.0));
}

/// A tag within reach.
struct FoundTag {
  Row row = kNoRow;
  EntityNumber number = kNoEntity;
  std::uint32_t id = 0;
  std::uint32_t data = 0;
  double squared_distance = 0.0;  ///< from the antenna [m2]
};

/// Position of the antenna of a model: its link Rfid::kLink. @throws ConfigError if the model has no such link
Transmitter antennaOf(const EntityModel& model, const char* device);

/// The parameter that all devices with an antenna have.
inline Parameter reachParameter() {
  return number("reach", "m", numberText(Rfid::kUsualReach), {0.001, 1.0},
                "Distance from the antenna beyond which no tag answers.");
}

/// Threads  one TagSearch per thread, kept between calls: its buffers grow to the size needed, and stay.
class TagSearch {
 public:
  /// Finds the tags within reach of a point, sorted by distance, then by entity number.
  /// @param antenna in W [m] @param reach [m] @return valid until the next call
  const std::vector<FoundTag>& find(const Space& space, const Eigen::Vector3d& antenna, double reach);

 private:
  std::vector<Row> near_;
  std::vector<FoundTag> found_;
};

}  // namespace swarmanoid::devices
