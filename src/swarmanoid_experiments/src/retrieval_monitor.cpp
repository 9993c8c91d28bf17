// Judges the object retrieval experiment: the run ends when a prey is in the nest. It is a success if the eyebot chose
// that prey, or if no robot chooses.
#include <string>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {

namespace {
constexpr const char* kNobodyChooses = "none";
}

class RetrievalMonitor final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "retrieval_monitor";
    description.summary = "Ends the run when a prey lies in the nest, and says which.";
    using Type = Parameter::Type;
    description.parameters = {
        makeParameter("nest", Type::kText, "", "nest", {}, "Id of the floor patch that is the nest."),
        makeParameter("chooser", Type::kText, "", "eb", {},
                      "Id of the robot whose debug value 'prey' names the right colour; none: any prey is right.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    nest_ = parameters.text("nest", "nest");
    chooser_ = parameters.text("chooser", "eb");
    std::vector<std::string> known;
    for (const FloorPatch& patch : context.experiment->arena.floor.patches) {
      known.push_back(patch.id);
    }
    if (!contains(known, nest_)) {
      throw ConfigError(parameters.location(), "nest: found '" + nest_ + "', allowed: the id of a floor patch (" +
                                                   joinNames(known) + ")" + didYouMean(nest_, known));
    }
  }

  void draw(const Space& space) override {
    if (delivered_.empty()) {
      lookForPrey(space);
      tick_ = space.tick;
    }
    if (chosen_.empty()) {
      lookForChoice(space);
    }
  }

  bool terminate() const override { return !delivered_.empty(); }
  std::optional<bool> success() const override {
    return !delivered_.empty() && (chooser_ == kNobodyChooses || delivered_color_ == chosen_);
  }

  void addMetrics(Metrics& metrics) const override {
    metrics["prey_in_nest"] = delivered_;
    metrics["prey_color"] = delivered_color_;
    metrics["chosen_color"] = chosen_;
    metrics["retrieval_ticks"] = static_cast<double>(tick_);
  }

  void reset() override {
    delivered_.clear();
    delivered_color_.clear();
    chosen_.clear();
    tick_ = 0;
  }

 private:
  void lookForPrey(const Space& space) {
    for (const FloorPatch& patch : space.floor.patches) {
      for (std::size_t k = 0; patch.id == nest_ && k < space.entities.order.size(); ++k) {
        const Row row = space.entities.order[k];
        const EntityModel& model = *space.entities.model[row];
        if (!model.is_robot && model.gripping_radius && patch.contains(space.entities.pose[row].position)) {
          delivered_ = space.entities.name[row];
          delivered_color_ = toString(space.entities.color[row]);
          return;
        }
      }
    }
  }

  void lookForChoice(const Space& space) {
    const Row row = space.entities.find(chooser_);
    if (row == kNoRow || !space.robots[row]) {
      return;
    }
    for (const auto& [key, value] : space.robots[row]->debugValues()) {
      if (key == "prey") {
        chosen_ = value;
      }
    }
  }

  std::string nest_;
  std::string chooser_;
  std::string delivered_;  // the prey's id; empty until one is delivered
  std::string delivered_color_;
  std::string chosen_;
  std::uint64_t tick_ = 0;
};

}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::RetrievalMonitor)
