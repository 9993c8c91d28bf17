// Trips: how often robots travel between two sets of floor patches, to judge foragers that carry nothing.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "common/parameters.hpp"
#include "floor_patch.hpp"
#include "listed_names.hpp"
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
    description.summary = "Counts trips of robots between floor patches, there and back.";
    description.parameters = {
        RobotGroup::parameter(),
        makeParameter("from", Type::kText, "", "nest", {}, "Ids of floor patches, one or several with commas between."),
        makeParameter("to", Type::kText, "", "food", {}, "Ids of other floor patches."),
        integer("enough", "0", {0.0, 1e9}, "Trips after which the run ends, a success; 0: it does not.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    group_ = RobotGroup(parameters.text("robots"));
    ids_ = {idsIn(parameters.text("from")), idsIn(parameters.text("to"))};
    for (const std::string& id : ids_[1]) {
      if (std::find(ids_[0].begin(), ids_[0].end(), id) != ids_[0].end()) {
        throw ConfigError(parameters.location(),
                          "to: found '" + id + "', which is from too, allowed: another floor patch");
      }
    }
    location_ = parameters.location();
    Metric& trips = addMetric("trips", "", "From one side to the other, in either direction.");
    Metric& per_minute = addMetric("trips_per_minute", "1/min", "Number per minute of simulated time.");
    returns_ = &addMetric("returns", "", "Trips that ended on a patch of `from`.");
    tally_ = Tally(trips, per_minute, static_cast<double>(parameters.integer("enough")));
  }

  void reset(const Space& space, InterventionQueue&) override {
    last_.clear();
    patches_.clear();
    for (std::size_t side = 0; side < ids_.size(); ++side) {
      for (const std::string& id : ids_[side]) {
        patches_.push_back({requireFloorPatch(space, side == kFrom ? "from" : "to", id, location_), side});
      }
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

  void archive(StateArchive& state) override { state(group_, last_); }

 private:
  static constexpr std::size_t kFrom = 0;  // index of the side `from`

  /// A floor patch of one of the two sides.
  struct Patch {
    std::size_t place = 0;  // among the floor's patches
    std::size_t side = kFrom;
  };
  /// The side on which a robot was last seen.
  struct Last {
    EntityNumber robot = kNoEntity;
    std::size_t side = kFrom;
  };

  /// At least one id; an empty id is refused later, since no patch has it.
  static std::vector<std::string> idsIn(const std::string& text) {
    std::vector<std::string> ids = listedNames(text);
    return ids.empty() ? std::vector<std::string>{""} : ids;
  }

  void look(const Space& space, Row row) {
    for (const Patch& patch : patches_) {
      if (!space.floor.patches[patch.place].contains(space.entities.pose[row].position)) {
        continue;
      }
      const EntityNumber number = space.entities.number[row];
      const auto last = std::lower_bound(last_.begin(), last_.end(), number,
                                         [](const Last& each, EntityNumber robot) { return each.robot < robot; });
      if (last == last_.end() || last->robot != number) {
        last_.insert(last, {number, patch.side});
      } else if (last->side != patch.side) {
        last->side = patch.side;
        tally_.add();
        returns_->value += patch.side == kFrom ? 1.0 : 0.0;
      }
      return;
    }
  }

  RobotGroup group_;
  std::array<std::vector<std::string>, 2> ids_;  // by side
  std::vector<Patch> patches_;
  SourceLocation location_;
  Tally tally_;
  Metric* returns_ = nullptr;
  std::vector<Last> last_;  // by entity number
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Trips)
