/// Horizontal distance of robots from the nearest other entity of a type.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "robot_group.hpp"
#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_space/index/positional_index_visits.hpp"

namespace swarmanoid::devices {

/// Phase `rule`, one thread. Allocates only when the number of entities reaches a new maximum.
class NearestOfKind {
 public:
  NearestOfKind() = default;
  /// @param kind the tag in <arena>, not an alias
  explicit NearestOfKind(std::string kind) : kind_(std::move(kind)) {}

  /// @pre group.look was called for the current state of the space
  /// @return the squared distance [m2] of each robot of the group, in its order; infinity without another target
  const std::vector<double>& look(const Space& space, const RobotGroup& group) {
    if (population_.hasChanged(space)) {
      updateTargets(space);
    }
    squares_.assign(group.rows().size(), kInfinity);
    constexpr std::size_t kFew = 16;  // up to this number, checking each is as fast
    if (targets_.size() > kFew) {
      askTheIndex(space, group);
    }
    for (std::size_t i = 0; i < squares_.size(); ++i) {
      if (squares_[i] == kInfinity) {
        squares_[i] = targets_.size() > kFew ? lookAround(space, group.rows()[i]) : lookAtEach(space, group.rows()[i]);
      }
    }
    expectAsBefore();
    return squares_;
  }

  /// For snapshots.
  void archive(StateArchive& state) {
    state(reach_);
    if (state.isLoading()) {
      population_ = {};
    }
  }

 private:
  void updateTargets(const Space& space) {
    targets_.clear();
    targets_.reserve(space.entities.size());
    is_target_.resize(space.entities.rowCount());
    std::fill(is_target_.begin(), is_target_.end(), char{0});
    for (const Row row : space.entities.order) {
      if (space.entities.model[row]->type == kind_) {
        targets_.push_back(row);
        is_target_[row] = 1;
      }
    }
    if (reach_ == 0.0 && !targets_.empty()) {
      reach_ = std::sqrt(space.size.x() * space.size.y() / static_cast<double>(targets_.size()));
    }
  }

  /// Searches for all robots at once, among the pairs within reach_, which suffices for most robots.
  void askTheIndex(const Space& space, const RobotGroup& group) {
    constexpr std::size_t kShare = 8;  // below one robot in so many entities, lookAround is faster
    if (group.rows().size() * kShare < space.entities.size()) {
      return;
    }
    const auto offer = [&](Row robot, Row other, double square) {
      const RobotGroup::Place place = group.placeOf(robot);
      if (place != RobotGroup::kNoPlace && is_target_[other] != 0) {
        double& nearest = squares_[static_cast<std::size_t>(place)];
        nearest = std::min(nearest, square);
      }
    };
    const auto is_large_meant = [&](Row row) {
      return is_target_[row] != 0 || group.placeOf(row) != RobotGroup::kNoPlace;
    };
    space.index.visitPairs(space.entities, reach_, is_large_meant, [&](Row one, Row other, double square) {
      offer(one, other, square);
      offer(other, one, square);
    });
  }

  /// Searches in growing circles. Beyond the arena's diagonal it checks all targets, which may be anywhere.
  double lookAround(const Space& space, Row robot) const {
    const Eigen::Vector2d centre = space.entities.pose[robot].position.head<2>();
    const double farthest = space.size.head<2>().norm();
    for (double radius = 2.0 * reach_; radius < farthest; radius *= 2.0) {
      double nearest = kInfinity;
      space.index.visitUpright(centre, radius, [&](Row row) {
        if (is_target_[row] != 0 && row != robot) {
          nearest = std::min(nearest, (space.entities.pose[row].position.head<2>() - centre).squaredNorm());
        }
      });
      if (nearest <= radius * radius) {  // else a target that was not visited may be nearer
        return nearest;
      }
    }
    return lookAtEach(space, robot);
  }

  double lookAtEach(const Space& space, Row robot) const {
    const Eigen::Vector2d centre = space.entities.pose[robot].position.head<2>();
    double nearest = kInfinity;
    for (const Row row : targets_) {
      if (row != robot) {
        nearest = std::min(nearest, (space.entities.pose[row].position.head<2>() - centre).squaredNorm());
      }
    }
    return nearest;
  }

  /// Sets the next search distance to twice the mean of this one, at which most robots find a target among few
  /// entities. Results do not depend on it.
  void expectAsBefore() {
    constexpr double kLeast = 0.01;  // m: circles must grow
    double sum = 0.0;
    double count = 0.0;
    for (const double square : squares_) {
      sum += square < kInfinity ? std::sqrt(square) : 0.0;
      count += square < kInfinity ? 1.0 : 0.0;
    }
    reach_ = count > 0.0 ? std::max(2.0 * sum / count, kLeast) : reach_;
  }

  std::string kind_;
  Population population_;
  std::vector<Row> targets_;  // by entity number
  RowMap<char> is_target_;    // 1: the row is a target
  std::vector<double> squares_;
  double reach_ = 0.0;  // m
};

}  // namespace swarmanoid::devices
