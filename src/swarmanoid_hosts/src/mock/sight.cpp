#include "sight.hpp"

#include <cmath>

namespace swarmanoid::mock {

std::vector<ColorBlob> blobsInView(const MockState& state, const IsInView& is_in_view) {
  std::vector<ColorBlob> blobs;
  const auto look = [&](const Beacon& beacon) {
    const Eigen::Vector3d seen = state.pose.toRobot(beacon.at);
    const double horizontal = std::hypot(seen.x(), seen.y());
    if (is_in_view(horizontal, beacon.at.z())) {
      blobs.push_back(
          {beacon.color, static_cast<float>(std::atan2(seen.y(), seen.x())), static_cast<float>(horizontal)});
    }
  };
  for (const Beacon& beacon : state.world.beacons) {
    look(beacon);
  }
  for (const auto& [device, spot] : state.spots) {
    look(spot);
  }
  return blobs;
}

}  // namespace swarmanoid::mock
