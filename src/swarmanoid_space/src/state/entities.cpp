#include "swarmanoid_space/state/entities.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {

Eigen::Vector3d meanVelocity(const Twist& twist, double dt) {
  const double turn_rate = twist.angular.norm();
  const double turn = turn_rate * dt;
  constexpr double kStraight = 1e-9;  // rad
  if (!(std::abs(turn) > kStraight)) {
    return twist.linear;
  }
  const Eigen::Vector3d axis = twist.angular / turn_rate;
  const Eigen::Vector3d along = axis * axis.dot(twist.linear);
  const double half_sine = std::sin(0.5 * turn);
  return along + (twist.linear - along) * (std::sin(turn) / turn) +
         axis.cross(twist.linear) * (2.0 * half_sine * half_sine / turn);
}

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/, const Pose& pose) {
  visitor.vector({name, "position"}, pose.position);
  visitor.quaternion({name, "orientation"}, pose.orientation);
}

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/, const Twist& twist) {
  visitor.vector({name, "linear"}, twist.linear);
  visitor.vector({name, "angular"}, twist.angular);
}

Row Entities::add(const std::string& entity_name, std::shared_ptr<const EntityModel> entity_model,
                  const Pose& entity_pose, Color entity_color) {
  SWARMANOID_EXPECTS(find(entity_name) == kNoRow);
  Row row = rowAt(rowCount());
  if (holes_.empty()) {
    columns.resize(rowCount() + 1);
  } else {
    row = holes_.back();
    holes_.pop_back();
  }
  addAt(row, EntityNumber{++last_number_}, entity_name, std::move(entity_model), entity_pose, entity_color);
  return row;
}

void Entities::addAt(Row row, EntityNumber own_number, const std::string& entity_name,
                     std::shared_ptr<const EntityModel> entity_model, const Pose& entity_pose, Color entity_color) {
  columns.reset(row, entity_model.get());
  number[row] = own_number;
  name[row] = entity_name;
  model[row] = std::move(entity_model);
  pose[row] = entity_pose;
  color[row] = entity_color;
  first_color[row] = entity_color;
  order.push_back(row);  // entity numbers only grow
  row_by_name_[entity_name] = row;
}

void Entities::remove(Row row) {
  row_by_name_.erase(name[row]);
  columns.reset(row, nullptr);
  order.erase(std::find(order.begin(), order.end(), row));
  holes_.push_back(row);
}

void Entities::clear() {
  columns.resize(0);
  order.clear();
  holes_.clear();
  row_by_name_.clear();
  last_number_ = 0;
}

Row Entities::find(const std::string& entity_name) const {
  const auto found = row_by_name_.find(entity_name);
  return found == row_by_name_.end() ? kNoRow : found->second;
}

Row Entities::find(EntityNumber entity_number) const {
  const auto found = std::lower_bound(order.begin(), order.end(), entity_number,
                                      [&](Row row, EntityNumber value) { return number[row] < value; });
  return found != order.end() && number[*found] == entity_number ? *found : kNoRow;
}

Row Entities::require(const std::string& entity_name) const {
  const Row row = find(entity_name);
  if (row == kNoRow) {
    std::vector<std::string> known;
    for (const Row other : order) {
      known.push_back(name[other]);
    }
    throw ConfigError({}, "there is no entity '" + entity_name + "'" + didYouMean(entity_name, known));
  }
  return row;
}

}  // namespace swarmanoid
