/// An engine for tests of handover: its entities continue with the twist at which they were added, and any two of them
/// overlap. It rejects robots with wheels unless `takes_wheels` is set.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "swarmanoid_space/access.hpp"

namespace swarmanoid::test {

class GlideEngine : public Engine {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "glide";
    description.parameters = {makeParameter("takes_wheels", Parameter::Type::kBoolean, "", "false", {}, "")};
    return description;
  }
  void configure(const std::string& id, const Configuration& parameters) override {
    id_ = id;
    takes_wheels_ = parameters.boolean("takes_wheels", false);
  }
  std::string unsupportedReason(const EntityModel&, const std::vector<DeviceUse>& devices) const override {
    const bool has_wheels = std::any_of(devices.begin(), devices.end(), [](const DeviceUse& device) {
      return device.mechanisms == std::vector<Mechanism>{{Mechanism::Kind::kWheels}};
    });
    return has_wheels && !takes_wheels_ ? "device 'footbot_wheels' cannot be simulated" : "";
  }
  std::string invalidPoseReason(const EntityModel&, const Pose&) const override { return ""; }
  Row overlap(const EntityModel&, const Pose&, Span<const Row> ignored) const override {
    const auto found = std::find_if(held_.begin(), held_.end(), [&](const Held& held) {
      return std::find(ignored.begin(), ignored.end(), held.row) == ignored.end();
    });
    return found == held_.end() ? kNoRow : found->row;
  }
  std::string unsupportedStateReason(const Space& space, Row row) const override {
    return unsupportedAttachmentReason(space, row);
  }
  void add(const Space&, Row row, Role role) override { held_.push_back({row, role}); }
  void remove(const Space&, Row row) override {
    const auto is_it = [row](const Held& held) { return held.row == row; };
    held_.erase(std::remove_if(held_.begin(), held_.end(), is_it), held_.end());
  }
  void place(const Space&, Row) override {}
  void clear() override { held_.clear(); }
  void move(const Space& space, const MoveAccess& access, Duration dt) override {
    for (const Held& held : held_) {
      if (held.role == Role::kMirror) {
        continue;
      }
      Pose& pose = access.pose[held.row];
      const Twist& twist = space.entities.twist[held.row];
      pose.position += twist.linear * toSeconds(dt);
      const double turn = twist.angular.norm() * toSeconds(dt);
      if (turn > 0.0) {
        pose.orientation = Eigen::AngleAxisd(turn, twist.angular.normalized()) * pose.orientation;
      }
    }
  }
  void connect(const Space&, const ConnectAccess&) override {}
  bool mayHit(const RayBundle&) const override { return false; }
  void raycast(const RayBundle&, Span<RayHit>) const override {}

 private:
  struct Held {
    Row row;
    Role role;
  };

  std::vector<Held> held_;
  bool takes_wheels_ = false;
};

}  // namespace swarmanoid::test
