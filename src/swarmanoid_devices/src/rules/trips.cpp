// Trips: how often robots come from one place of the floor to another, to judge foragers that carry nothing.
#include <algorithm>
#include <array>
#include <vector>

#include "../parameters.hpp"
#include "floor_patch.hpp"
#include "robot_group.hpp"
#include "swarmanoid_space/rule.hpp"
#include "tally.hpp"

namespace swarmanoid::devices {
namespace {

class Trips final : public Rule {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "trips";
    description.summary = "Counts how often robots come from one floor patch to another, there and back.";
    description.parameters = {
        RobotGroup::parameter(), makeParameter("from", Type::kText, "", "nest", {}, "Id of a floor patch."),
        makeParameter("to", Type::kText, "", "food", {}, "Id of another one."),
        integer("enough", "0", {0.0, 1e9}, "Trips after which the run ends, a success; 0: it does not.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    group_ = RobotGroup(parameters.text("robots"));
    ids_ = {parameters.text("from"), parameters.text("to")};
    if (ids_[0] == ids_[1]) {
      throw ConfigError(parameters.location(),
                        "to: found '" + ids_[1] + "', which is from too, allowed: another floor patch");
    }
    location_ = parameters.location();
    Metric& trips = addMetric("trips", "", "From one patch to the other, in either direction.");
    Metric& per_minute = addMetric("trips_per_minute", "1/min", "As many in each minute of simulated time.");
    tally_ = Tally(trips, per_minute, static_cast<double>(parameters.integer("enough")));
  }

  void reset(const Space& space, InterventionQueue&) override {
    last_.clear();
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      patches_[i] = requireFloorPatch(space, i == 0 ? "from" : "to", ids_[i], location_);
    }
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    group_.look(space);
    for (const Row row : group_.rows()) {
      look(space, row);
    }
    tally_.measure(space);
  }

  bool isFinished() const override { return tally_.isEnough(); }
  std::optional<bool> success() const override { return tally_.success(); }

 private:
  /// The patch on which a robot was last.
  struct Last {
    EntityNumber robot = kNoEntity;
    std::size_t patch = 0;
  };

  void look(const Space& space, Row row) {
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (!space.floor.patches[patches_[i]].contains(space.entities.pose[row].position)) {
        continue;
      }
      const EntityNumber number = space.entities.number[row];
      const auto last = std::lower_bound(last_.begin(), last_.end(), number,
                                         [](const Last& each, EntityNumber robot) { return each.robot < robot; });
      if (last == last_.end() || last->robot != number) {
        last_.insert(last, {number, i});
      } else if (last->patch != i) {
        last->patch = i;
        tally_.add();
      }
      return;
    }
  }

  RobotGroup group_;
  std::array<std::string, 2> ids_;
  std::array<std::size_t, 2> patches_{};
  SourceLocation location_;
  Tally tally_;
  std::vector<Last> last_;  // by number
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Trips)
