#include "tags.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

#include "mechanisms.hpp"
#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid::devices {

Transmitter antennaOf(const EntityModel& model, const char* device) {
  const auto mount = model.mounts.find(Rfid::kLink);
  if (mount == model.mounts.end()) {
    refuseWithout(device, model, std::string("the link ") + Rfid::kLink);
  }
  return {mount->second.position, mount->second.joint};
}

const std::vector<FoundTag>& TagSearch::find(const Space& space, const Eigen::Vector3d& antenna, double reach) {
  near_.clear();
  found_.clear();
  space.index.collect(antenna, reach, near_);
  for (const Row row : near_) {
    const double squared_distance = (space.entities.pose[row].position - antenna).squaredNorm();
    if (squared_distance > reach * reach) {
      continue;
    }
    const std::optional<double> id = space.property(row, kTag);
    const std::optional<double> data = id ? space.property(row, kTagData) : std::nullopt;
    if (data) {
      found_.push_back({row, space.entities.number[row], tagNumber(*id), tagNumber(*data), squared_distance});
    }
  }
  std::sort(found_.begin(), found_.end(), [](const FoundTag& a, const FoundTag& b) {
    return std::tie(a.squared_distance, a.number) < std::tie(b.squared_distance, b.number);
  });
  return found_;
}

}  // namespace swarmanoid::devices
