/// An engine for tests of handover: what it is given glides on with the twist that it came with. No collisions, no
/// wheels.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::test {

class GlideEngine final : public Engine {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "glide";
    return description;
  }
  void configure(const std::string& id, const Configuration&) override { id_ = id; }
  std::string refusal(const EntityModel&, const std::vector<std::string>& devices) const override {
    const bool has_wheels = std::find(devices.begin(), devices.end(), FootbotWheels::kType) != devices.end();
    return has_wheels ? "device 'footbot_wheels' cannot be simulated" : "";
  }
  std::string misplacement(const EntityModel&, const Pose&) const override { return ""; }
  Row overlap(const EntityModel&, const Pose&, Span<const Row>) const override { return kNoRow; }
  void add(Space&, Row row, Role role) override {
    if (role == Role::kMove) {
      rows_.push_back(row);
    }
  }
  void remove(Space&, Row row) override { rows_.erase(std::remove(rows_.begin(), rows_.end(), row), rows_.end()); }
  void place(Space&, Row) override {}
  void clear() override { rows_.clear(); }
  void move(Space& space, Duration dt) override {
    for (const Row row : rows_) {
      const auto i = static_cast<std::size_t>(row);
      Pose& pose = space.entities.pose[i];
      const Twist& twist = space.entities.twist[i];
      pose.position += twist.linear * toSeconds(dt);
      const double turn = twist.angular.norm() * toSeconds(dt);
      if (turn > 0.0) {
        pose.orientation = Eigen::AngleAxisd(turn, twist.angular.normalized()) * pose.orientation;
      }
    }
  }
  void connect(Space&) override {}
  bool mayMeet(const RayBundle&) const override { return false; }
  void castRays(const RayBundle&, Span<RayHit>) const override {}

 private:
  std::vector<Row> rows_;
};

}  // namespace swarmanoid::test
