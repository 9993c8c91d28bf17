// The vacuum in the cups of a handbot's hands: for each cup the share of points of its lip and centre that lie on a
// solid.
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"

#include <string>

#include "common/holders.hpp"
#include "sensors/rays/hand_rays.hpp"

namespace swarmanoid::devices {
namespace {

struct CupsInstance : BasicSensorInstance<HandbotVacuum> {
  std::size_t count = 0;  // of each hand
  std::array<std::array<Mount, HandbotVacuum::kMostCups>, 2> cups;

  void archive(StateArchive& /*state*/) {}
};

class HandbotVacuumSensor final : public HolderSensor<HandbotVacuumSensor, HandbotVacuum, 2, CupsInstance> {
  using Base = HolderSensor<HandbotVacuumSensor, HandbotVacuum, 2, CupsInstance>;

 public:
  static constexpr auto kHolders = kHandHolders;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotVacuum::kType;
    description.implementation = "lip";
    description.is_default = true;
    description.summary =
        "Of each cup the share of its lip and middle that lies on something, while the suction is on.";
    return description;
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const Instance& instance = instances_[k];
      senseHand(space, instance, 0, instance.readings->left);
      senseHand(space, instance, 1, instance.readings->right);
    }
  }

 protected:
  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    const auto& mounts = space.entities.model[instance.row]->mounts;
    for (std::size_t i = 0; i < HandbotVacuum::kMostCups; ++i) {
      const auto left = mounts.find("left_cup_" + std::to_string(i));
      const auto right = mounts.find("right_cup_" + std::to_string(i));
      if (left == mounts.end() || right == mounts.end()) {
        break;
      }
      instance.cups[0][i] = left->second;
      instance.cups[1][i] = right->second;
      ++instance.count;
    }
    if (instance.count == 0) {
      throw ConfigError({}, std::string("found the device '") + HandbotVacuum::kType +
                                "' on a robot without links left_cup_0 and right_cup_0, allowed: on robots with cups");
    }
  }

  /// Draws the lips, in the shade of the readings.
  void drawOne(const Space& space, const Instance& instance, DeviceDrawing& drawing) const override {
    constexpr double kRadius = HandbotVacuum::kCupRadius;
    const HandbotVacuum& readings = this->delivered(instance);
    for (std::size_t hand = 0; hand < instance.cups.size(); ++hand) {
      for (std::size_t i = 0; i < instance.count; ++i) {
        const Eigen::Isometry3d cup = placeInWorld(space, instance.row, instance.cups[hand][i]);
        const float vacuum = hand == 0 ? readings.left[i] : readings.right[i];
        drawing.circle(cup.translation(), kRadius * cup.linear().col(1), kRadius * cup.linear().col(2),
                       DeviceDrawing::shade(static_cast<double>(vacuum)));
      }
    }
  }

 private:
  static constexpr std::size_t kPoints = HandbotVacuum::kLipPoints + 1;

  static void senseHand(const Space& space, const Instance& instance, std::size_t hand,
                        std::array<float, HandbotVacuum::kMostCups>& vacuum) {
    const int holder = instance.holders[hand];
    const bool sucks = holder >= 0 && space.holder_commands[instance.row][static_cast<std::size_t>(holder)].holds;
    for (std::size_t i = 0; i < instance.count; ++i) {
      vacuum[i] = sucks ? closedShare(space, instance.row, instance.cups[hand][i]) : 0.0F;
    }
  }

  static float closedShare(const Space& space, Row robot, const Mount& cup) {
    constexpr double kReach = HandbotVacuum::kReach;
    constexpr double kRadius = HandbotVacuum::kCupRadius;
    const Eigen::Isometry3d place = placeInWorld(space, robot, cup);
    RayBundle rays = bundleAround(robot, place, kReach + kRadius);
    if (!space.mayHit(rays)) {
      return 0.0F;
    }
    std::array<Segment, kPoints> segments;
    std::array<RayHit, kPoints> hits;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double angle = 2.0 * M_PI * static_cast<double>(i) / HandbotVacuum::kLipPoints;
      const double radius = i == HandbotVacuum::kLipPoints ? 0.0 : kRadius;  // the last point is the centre
      const Eigen::Vector3d point(0.0, radius * std::cos(angle), radius * std::sin(angle));
      const Eigen::Vector3d out(kReach, 0.0, 0.0);
      segments[i] = {place * Eigen::Vector3d(point - out), place * Eigen::Vector3d(point + out)};
    }
    rays.segments = Span<const Segment>(segments.data(), kPoints);
    space.raycast(rays, Span<RayHit>(hits.data(), kPoints));
    std::size_t closed = 0;
    for (const RayHit& hit : hits) {
      closed += hit.isHit() ? 1 : 0;
    }
    return static_cast<float>(closed) / static_cast<float>(kPoints);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotVacuumSensor)
