/// The radio tags around an antenna: whatever has the properties kTag and kTagData. Readers and writers share it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "parameters.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"
#include "swarmanoid_space/space.hpp"
#include "transmitters.hpp"

namespace swarmanoid::devices {

/// What devices read of a number of a tag: a package's property may hold what is no uint32, of which the nearest
/// counts.
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

/// Where the antenna is on a robot of a model: at the link Rfid::kLink. @throws ConfigError if it has none
Transmitter antennaOf(const EntityModel& model, const char* device);

/// The parameter of all devices with an antenna.
inline Parameter reachParameter() {
  return number("reach", "m", numberText(Rfid::kUsualReach), {0.001, 1.0},
                "Distance from the antenna beyond which no tag answers.");
}

/// Threads  each needs a TagSearch of its own, and keeps it: its room grows to what was needed, and stays.
class TagSearch {
 public:
  /// Finds the tags within reach of a point, the nearest first, of equally near ones that of the lower entity number.
  /// @param antenna in W [m] @param reach [m] @return valid until the next call
  const std::vector<FoundTag>& find(const Space& space, const Eigen::Vector3d& antenna, double reach);

 private:
  std::vector<Row> near_;
  std::vector<FoundTag> found_;
};

}  // namespace swarmanoid::devices
