/// The robots that a rule measures, those whose names begin alike, and whether they are still the same.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class RobotGroup {
 public:
  RobotGroup() = default;
  explicit RobotGroup(std::string beginning) : beginning_(std::move(beginning)) {}

  static Parameter parameter() {
    return makeParameter("robots", Parameter::Type::kText, "", "", {},
                         "What the names of those that count begin with; empty: all robots.");
  }

  bool has(const Space& space, Row row) const {
    return space.entities.model[row]->is_robot &&
           space.entities.name[row].compare(0, beginning_.size(), beginning_) == 0;
  }

  /// The mean of their positions in W, seen from above [m]. @return nothing if there are none
  std::optional<Eigen::Vector2d> centroid(const Space& space) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double robots = 0.0;
    for (const Row row : space.entities.order) {
      if (has(space, row)) {
        sum += space.entities.pose[row].position.head<2>();
        robots += 1.0;
      }
    }
    return robots > 0.0 ? std::optional<Eigen::Vector2d>(sum / robots) : std::nullopt;
  }

 private:
  std::string beginning_;
};

/// Who is in a group: where robots come or go, its centroid jumps, which is no motion.
class Roster {
 public:
  /// For a run that begins: it knows nobody.
  void clear() { numbers_.clear(); }

  /// Allocates only while there are more robots than ever before.
  /// @return whether others are in the group than at the last call
  bool update(const Space& space, const RobotGroup& group) {
    numbers_.reserve(space.entities.size());
    bool is_changed = false;
    std::size_t robots = 0;
    for (const Row row : space.entities.order) {
      if (!group.has(space, row)) {
        continue;
      }
      const EntityNumber number = space.entities.number[row];
      if (robots == numbers_.size()) {
        numbers_.push_back(kNoEntity);
      }
      is_changed = is_changed || numbers_[robots] != number;
      numbers_[robots] = number;
      ++robots;
    }
    is_changed = is_changed || robots != numbers_.size();
    numbers_.resize(robots);
    return is_changed;
  }

 private:
  std::vector<EntityNumber> numbers_;  // that grow
};

}  // namespace swarmanoid::devices
