#include "world_fields.hpp"

#include <utility>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::diff {
namespace {

class Collector {
 public:
  void addVector(const std::string& begin, double x, double y, double z) {
    add(begin + "/x", x);
    add(begin + "/y", y);
    add(begin + "/z", z);
  }
  void add(const std::string& name, double value) {
    names_.push_back(name);
    fields_.numbers.push_back(value);
  }
  void add(const std::string& name, const std::string& value) {
    text_names_.push_back(name);
    fields_.texts.push_back(value);
  }
  StateFields take() {
    names_.insert(names_.end(), text_names_.begin(), text_names_.end());
    fields_.names = std::make_shared<const std::vector<std::string>>(std::move(names_));
    return std::move(fields_);
  }

 private:
  StateFields fields_;
  std::vector<std::string> names_;
  std::vector<std::string> text_names_;
};

void refuseUnequalLengths(const swarmanoid_msgs::WorldState& state, const std::string& file) {
  const std::pair<const char*, std::size_t> lengths[] = {{"poses", state.poses.size()},
                                                         {"twists", state.twists.size()},
                                                         {"colors", state.colors.size()},
                                                         {"gripped", state.gripped.size()},
                                                         {"engines", state.engines.size()}};
  for (const auto& [field, length] : lengths) {
    if (length != state.names.size()) {
      throw ConfigError({file, 0}, "found " + std::to_string(length) + " " + field + " of " +
                                       std::to_string(state.names.size()) + " entities in the world state after tick " +
                                       std::to_string(state.tick) + "; expected as many");
    }
  }
}

}  // namespace

StateFields worldFields(const swarmanoid_msgs::WorldState& state, const std::string& file) {
  refuseUnequalLengths(state, file);
  Collector fields;
  for (std::size_t i = 0; i < state.names.size(); ++i) {
    const std::string& name = state.names[i];
    const geometry_msgs::Pose& pose = state.poses[i];
    fields.addVector(name + "/pose/position", pose.position.x, pose.position.y, pose.position.z);
    fields.addVector(name + "/pose/orientation", pose.orientation.x, pose.orientation.y, pose.orientation.z);
    fields.add(name + "/pose/orientation/w", pose.orientation.w);
    const geometry_msgs::Twist& twist = state.twists[i];
    fields.addVector(name + "/twist/linear", twist.linear.x, twist.linear.y, twist.linear.z);
    fields.addVector(name + "/twist/angular", twist.angular.x, twist.angular.y, twist.angular.z);
    const std_msgs::ColorRGBA& color = state.colors[i];
    fields.addVector(name + "/mean_color", color.r, color.g, color.b);
    fields.add(name + "/gripped", state.gripped[i]);
    fields.add(name + "/engine", state.engines[i]);
  }
  return fields.take();
}

}  // namespace swarmanoid::diff
