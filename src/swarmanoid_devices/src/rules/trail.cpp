// A trail: robots that show a colour paint the floor under them, for others to find (stigmergy).
#include <algorithm>

#include "common/parameters.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

class Trail final : public Rule {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "trail";
    description.summary = "Paints the floor under robots whose LEDs show a colour.";
    description.parameters = {
        makeParameter("led_color", Type::kColor, "", "magenta", {}, "Of an LED of a robot that lays a trail."),
        makeParameter("color", Type::kColor, "", "black", {}, "Of the paint."),
        number("strength", "", "0.3", PaintFloor::kStrength, "Of one layer of paint, over the colour below."),
        number("radius", "m", "0.04", PaintFloor::kRadius, "Of the disc that is painted under a robot's origin."),
        integer("every", "1", {1.0, 1e6}, "Ticks from one disc of a robot to the next.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    led_color_ = parameters.color("led_color");
    disc_.color = parameters.color("color");
    disc_.strength = parameters.number("strength");
    disc_.radius = parameters.number("radius");
    every_ = static_cast<std::uint64_t>(parameters.integer("every"));
    location_ = parameters.location();
    painting_ = &addMetric("painting", "", "Robots under which the floor was painted last.");
  }

  void reset(const Space& space, InterventionQueue&) override {
    if (!space.floor.paint.exists()) {
      throw ConfigError(location_, "found the rule 'trail', allowed: in an arena with <floor_paint>");
    }
  }

  void afterTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick % every_ != 0) {
      return;
    }
    PaintFloor paint;
    for (const Row row : space.entities.order) {
      const Eigen::Vector3d& at = space.entities.pose[row].position;
      if (space.outside[row] == 0 && shows(space.leds[row])) {
        // a robot on the border counts as inside, but may be beyond it by rounding
        disc_.position = at.head<2>().cwiseMax(space.corner.head<2>()).cwiseMin(space.farCorner().head<2>());
        paint.discs.push_back(disc_);
      }
    }
    painting_->value = static_cast<double>(paint.discs.size());
    if (!paint.discs.empty()) {
      queue.ask(std::move(paint));
    }
  }

  void archive(StateArchive& /*state*/) override {}

 private:
  bool shows(Span<const Color> leds) const { return std::find(leds.begin(), leds.end(), led_color_) != leds.end(); }

  Color led_color_;
  PaintDisc disc_;
  std::uint64_t every_ = 1;
  SourceLocation location_;
  Metric* painting_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Trail)
