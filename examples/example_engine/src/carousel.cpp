// A carousel: moves its entities around a vertical axis at a constant rate, without collisions.
#include <algorithm>
#include <vector>

#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"
#include "swarmanoid_space/space.hpp"

using swarmanoid::ConnectAccess;
using swarmanoid::EntityModel;
using swarmanoid::MoveAccess;
using swarmanoid::Pose;
using swarmanoid::Row;
using swarmanoid::Space;

class Carousel final : public swarmanoid::Engine {
 public:
  static swarmanoid::PluginDescription describe() {
    swarmanoid::Parameter axis;
    axis.name = "axis";
    axis.type = swarmanoid::Parameter::Type::kVector2;
    axis.unit = "m";
    axis.description = "Where the axis stands.";
    swarmanoid::Parameter rate;
    rate.name = "rate";
    rate.type = swarmanoid::Parameter::Type::kNumber;
    rate.unit = "deg/s";
    rate.value = "30";
    rate.description = "How fast it turns, counter-clockwise seen from above.";
    swarmanoid::PluginDescription description;
    description.label = "carousel";
    description.summary = "Takes entities round an axis; no collisions.";
    description.parameters = {axis, rate};
    return description;
  }

  void configure(const std::string& id, const swarmanoid::Configuration& parameters) override {
    id_ = id;
    axis_.head<2>() = parameters.vector2("axis");
    rate_ = parameters.angle("rate", 0.0);
  }

  std::string unsupportedReason(const EntityModel&, const std::vector<swarmanoid::DeviceUse>& devices) const override {
    using Kind = swarmanoid::Mechanism::Kind;
    for (const swarmanoid::DeviceUse& device : devices) {
      for (const swarmanoid::Mechanism& mechanism : device.mechanisms) {
        if (mechanism.kind == Kind::kWheels || mechanism.kind == Kind::kFlight) {
          return "device '" + device.type + "' cannot be simulated: who stands on a carousel does not drive";
        }
      }
    }
    return "";
  }
  std::string invalidPoseReason(const EntityModel&, const Pose&) const override { return ""; }
  Row overlap(const EntityModel&, const Pose&, swarmanoid::Span<const Row>) const override {
    return swarmanoid::kNoRow;
  }

  void add(const Space& space, Row row, swarmanoid::Role role) override {
    // rays hit a mirrored entity in the engine that moves it, so this engine ignores mirrors
    if (role == swarmanoid::Role::kMove) {
      riders_.push_back({row, space.entities.model[row], space.entities.pose[row]});
    }
  }
  void remove(const Space&, Row row) override {
    const auto is_it = [row](const Rider& rider) { return rider.row == row; };
    riders_.erase(std::remove_if(riders_.begin(), riders_.end(), is_it), riders_.end());
  }
  void place(const Space& space, Row row) override {
    for (Rider& rider : riders_) {
      rider.pose = rider.row == row ? space.entities.pose[row] : rider.pose;
    }
  }
  void clear() override { riders_.clear(); }
  void archive(const Space& space, swarmanoid::StateArchive& state) override {
    for (Rider& rider : riders_) {
      rider.pose = state.isLoading() ? space.entities.pose[rider.row] : rider.pose;  // nothing of its own to save
    }
  }

  void move(const Space&, const MoveAccess& access, swarmanoid::Duration dt) override {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(rate_ * swarmanoid::toSeconds(dt), Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d spin(0.0, 0.0, rate_);
    for (Rider& rider : riders_) {
      if (rider.model->is_movable) {
        rider.pose.position = axis_ + turn * (rider.pose.position - axis_);
        rider.pose.orientation = (turn * rider.pose.orientation).normalized();
        access.pose[rider.row] = rider.pose;
        access.twist[rider.row] = {spin.cross(rider.pose.position - axis_), spin};
      }
    }
  }
  void connect(const Space&, const ConnectAccess&) override {}

  bool mayHit(const swarmanoid::RayBundle&) const override { return !riders_.empty(); }
  void raycast(const swarmanoid::RayBundle& rays, swarmanoid::Span<swarmanoid::RayHit> hits) const override {
    for (const Rider& rider : riders_) {
      for (std::size_t k = 0; k < rays.segments.size() && rider.row != rays.ignored && rider.row != rays.also_ignored;
           ++k) {
        const double fraction = swarmanoid::closestHit(rays.segments[k], *rider.model, rider.pose);
        if (fraction < hits[k].fraction) {
          hits[k] = {fraction, rider.row};
        }
      }
    }
  }

 private:
  struct Rider {
    Row row;
    std::shared_ptr<const EntityModel> model;
    Pose pose;  // copy of the pose in the space
  };

  std::vector<Rider> riders_;
  Eigen::Vector3d axis_ = Eigen::Vector3d::Zero();  // [m]
  double rate_ = 0.0;                               // [rad/s]
};

REGISTER_ENGINE(Carousel)
