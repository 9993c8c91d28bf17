/// Positions of the sensors of a ring: families of sensors around a body take them from the robot's description.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "common/mechanisms.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/models/shared_by_model.hpp"

namespace swarmanoid::devices {

constexpr int kMostRingSensors = 64;

/// Positions and directions of the sensors of a model, in its body frame. @tparam count of sensors, or Eigen::Dynamic
template <int count>
struct RingGeometry {
  static constexpr int kMost = count == Eigen::Dynamic ? kMostRingSensors : count;
  using Points = Eigen::Matrix<double, 3, count, 0, 3, kMost>;  // never on the heap

  Points from;
  Points direction;  // x axes of the links, of length 1
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;  // of a sphere around the centre that contains the sensors, m

  std::size_t size() const { return static_cast<std::size_t>(from.cols()); }
};

/// Name of the links of a ring: the first of `names` that the model has, or names.front() if it has none.
inline std::string ringNameOf(const EntityModel& model, const std::vector<std::string>& names) {
  const auto is_there = [&model](const std::string& name) { return model.mounts.count(name + "_0") > 0; };
  const auto found = std::find_if(names.begin(), names.end(), is_there);
  return found == names.end() ? names.front() : *found;
}

/// @param names possible names of the links @param chosen ringNameOf for these
/// @param found number of links with the chosen name @param allowed number of links, as text
/// @throws ConfigError always
[[noreturn]] inline void refuseRing(const char* device, const EntityModel& model, const std::vector<std::string>& names,
                                    const std::string& chosen, Eigen::Index found, const std::string& allowed) {
  if (found == 0) {
    std::string links = "links " + names.front() + "_0, ...";
    for (std::size_t i = 1; i < names.size(); ++i) {
      links += " or " + names[i] + "_0, ...";
    }
    refuseWithout(device, model, links + " (" + allowed + ")");
  }
  std::string text = "found the device '" + std::string(device) + "' on a " + model.type + " with links " + chosen +
                     "_0, ... (" + std::to_string(found) + "), allowed: " + allowed;
  if (chosen != names.back()) {
    text += "; links of other names count only on robots without " + chosen + "_0";
  }
  throw ConfigError({}, text);
}

/// The ring of the links <name>_0, <name>_1, ..., where <name> is the first of `names` that the model has.
/// @throws ConfigError if the model has no such links, too few, or more than allowed
template <int count>
RingGeometry<count> ringOf(const EntityModel& model, const char* device, const std::vector<std::string>& names) {
  const std::string name = ringNameOf(model, names);
  const auto linkOf = [&name](Eigen::Index i) { return name + "_" + std::to_string(i); };
  Eigen::Index found = 0;
  while (model.mounts.count(linkOf(found)) > 0) {
    ++found;
  }
  const bool is_right = count == Eigen::Dynamic ? found > 0 && found <= RingGeometry<count>::kMost : found >= count;
  if (!is_right) {
    refuseRing(
        device, model, names, name, found,
        count == Eigen::Dynamic ? "1 to " + std::to_string(kMostRingSensors) : std::to_string(count) + " or more");
  }
  RingGeometry<count> ring;
  if constexpr (count == Eigen::Dynamic) {
    ring.from.resize(3, found);
    ring.direction.resize(3, found);
  }
  for (Eigen::Index i = 0; i < ring.from.cols(); ++i) {
    const Mount& mount = model.mount(linkOf(i));
    ring.from.col(i) = mount.position;
    ring.direction.col(i) = mount.orientation * Eigen::Vector3d::UnitX();
  }
  ring.centre = ring.from.rowwise().mean();
  ring.radius = (ring.from.colwise() - ring.centre).colwise().norm().maxCoeff();
  return ring;
}

/// The rings of all robots with one sensor; robots of one type share theirs, also with other worlds.
template <int count>
class Rings {
 public:
  /// @throws ConfigError as ringOf
  std::shared_ptr<const RingGeometry<count>> of(const std::shared_ptr<const EntityModel>& model, const char* device,
                                                const std::vector<std::string>& names) {
    const auto found =
        std::find_if(rings_.begin(), rings_.end(), [&](const Ring& ring) { return ring.model == model; });
    if (found != rings_.end()) {
      return found->geometry;
    }
    static SharedByModel<std::vector<std::string>, RingGeometry<count>> shared;
    rings_.push_back({model, shared.get(model, names, [&] { return ringOf<count>(*model, device, names); })});
    return rings_.back().geometry;
  }

 private:
  struct Ring {
    std::shared_ptr<const EntityModel> model;  // kept alive, so that no other model gets its address
    std::shared_ptr<const RingGeometry<count>> geometry;
  };

  std::vector<Ring> rings_;
};

}  // namespace swarmanoid::devices
