// A lamp that switches on and off at fixed times, alone or in alternation with another one. The state depends only on
// the time of the tick, so a lamp that was switched from outside is corrected before the next tick.
#include <cmath>
#include <string>
#include <vector>

#include "common/parameters.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

class SwitchingLamp final : public Rule {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "switching_lamp";
    description.summary = "Switches a lamp on and off, and a second lamp in alternation.";
    description.parameters = {
        makeParameter("lamp", Type::kText, "", std::nullopt, {}, "Id of the lamp, lit when the run begins."),
        makeParameter("other", Type::kText, "", "", {},
                      "Id of a lamp that is lit while the first one is dark; empty: none."),
        number("period", "s", "60", {0.001, 1e6}, "Duration of one cycle of the lamp."),
        number("duty", "", "0.5", {0.0, 1.0}, "Part of the period for which the lamp is lit."),
        number("intensity", "", "1", kIntensityRange, "Of a lamp that is lit, in the brightness of an LED.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    lamp_ = parameters.text("lamp");
    other_ = parameters.text("other");
    location_ = parameters.location();
    if (lamp_ == other_) {
      throw ConfigError(location_, "other: found '" + other_ + "', allowed: another lamp than lamp");
    }
    constexpr double kNanoseconds = 1e9;
    period_ = Duration(std::llround(parameters.number("period") * kNanoseconds));
    lit_for_ = Duration(std::llround(parameters.number("period") * parameters.number("duty") * kNanoseconds));
    intensity_ = parameters.number("intensity");
    switches_ = &addMetric("switches", "", "Number of changes of the lit lamp.");
    distance_ = &addMetric("distance", "m", "Mean distance of the robots from the lamp that is lit, seen from above.");
    distance_before_switch_ =
        &addMetric("distance_before_switch", "m", "Mean of that distance over the ticks just before a switch.");
  }

  void reset(const Space& space, InterventionQueue&) override {
    was_first_lit_ = isFirstLit(space.time - kEpoch);
    sum_before_switch_ = 0.0;
    requireLamp(space, "lamp", lamp_);
    if (!other_.empty()) {
      requireLamp(space, "other", other_);
    }
  }

  void beforeTick(const Space& space, InterventionQueue& queue) override {
    const bool is_first_lit = isFirstLit(space.time - kEpoch);
    if (is_first_lit != was_first_lit_) {
      was_first_lit_ = is_first_lit;
      switches_->value += 1.0;
      sum_before_switch_ += distance_->value;
      distance_before_switch_->value = sum_before_switch_ / switches_->value;
    }
    shine(space, queue, lamp_, is_first_lit);
    shine(space, queue, other_, !is_first_lit);
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    const Row lamp = space.entities.find(was_first_lit_ ? lamp_ : other_);
    distance_->value = lamp == kNoRow ? 0.0 : meanDistance(space, space.entities.pose[lamp].position);
  }

  void archive(StateArchive& state) override { state(was_first_lit_, sum_before_switch_); }

 private:
  /// @param elapsed since the run began
  bool isFirstLit(Duration elapsed) const { return elapsed % period_ < lit_for_; }

  void requireLamp(const Space& space, const std::string& parameter, const std::string& id) const {
    std::vector<std::string> known;
    for (const Row row : space.entities.order) {
      if (space.property(row, kIntensity)) {
        known.push_back(space.entities.name[row]);
        if (known.back() == id) {
          return;
        }
      }
    }
    throw ConfigError(location_, parameter + ": found '" + id + "', allowed: the id of what has the property " +
                                     kIntensity + " (" + joinNames(known) + ")" + didYouMean(id, known));
  }

  /// Requests a change only if needed: a tick without a switch makes no request. A deleted lamp is skipped.
  void shine(const Space& space, InterventionQueue& queue, const std::string& id, bool is_lit) const {
    const Row row = space.entities.find(id);
    if (row == kNoRow) {
      return;
    }
    const double intensity = is_lit ? intensity_ : 0.0;
    const std::optional<double> now = space.property(row, kIntensity);
    if (now && *now != intensity) {
      queue.ask(SetProperty{id, kIntensity, numberText(intensity)});
    }
  }

  /// @return 0 if there is no robot
  static double meanDistance(const Space& space, const Eigen::Vector3d& lamp) {
    double sum = 0.0;
    double robots = 0.0;
    for (const Row row : space.entities.order) {
      if (space.entities.model[row]->is_robot) {
        sum += (space.entities.pose[row].position - lamp).head<2>().norm();
        robots += 1.0;
      }
    }
    return robots > 0.0 ? sum / robots : 0.0;
  }

  std::string lamp_;
  std::string other_;  // "": none
  Duration period_{};
  Duration lit_for_{};  // part of each period
  double intensity_ = 1.0;
  SourceLocation location_;
  bool was_first_lit_ = true;
  double sum_before_switch_ = 0.0;  // m
  Metric* switches_ = nullptr;
  Metric* distance_ = nullptr;
  Metric* distance_before_switch_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::SwitchingLamp)
