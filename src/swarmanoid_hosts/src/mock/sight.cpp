#include "sight.hpp"

#include <cmath>
#include <limits>

namespace swarmanoid::mock {
namespace {

ColorBlob blobOf(Color color, const Eigen::Vector3d& way, bool knows_distance) {
  const double horizontal = std::hypot(way.x(), way.y());
  ColorBlob blob;
  blob.color = color;
  blob.bearing = static_cast<float>(std::atan2(way.y(), way.x()));
  blob.distance = knows_distance ? static_cast<float>(horizontal) : std::numeric_limits<float>::quiet_NaN();
  blob.elevation = static_cast<float>(std::atan2(way.z(), horizontal));
  blob.size = ColorBlob::sizeOf(static_cast<float>(ColorBlob::kPointRadius), static_cast<float>(way.norm()));
  return blob;
}

}  // namespace

std::vector<ColorBlob> blobsInView(const MockState& state, const View& view) {
  std::vector<ColorBlob> blobs;
  const auto look = [&](const Beacon& beacon) {
    const Eigen::Vector3d way = state.pose.toRobot(beacon.at) - view.camera;
    if (way.head<2>().norm() <= view.range && view.shows(way)) {
      blobs.push_back(blobOf(beacon.color, way, view.knows_distance));
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
