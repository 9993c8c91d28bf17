// Moves an entity to a random place of the arena at regular intervals, and counts the moves.
#include "swarmanoid_space/rule.hpp"

using swarmanoid::Configuration;
using swarmanoid::InterventionQueue;
using swarmanoid::Parameter;
using swarmanoid::Space;

class Relocation final : public swarmanoid::Rule {
 public:
  static swarmanoid::PluginDescription describe() {
    Parameter entity;
    entity.name = "entity";
    entity.description = "What is put elsewhere.";
    Parameter every;
    every.name = "every";
    every.type = Parameter::Type::kInteger;
    every.unit = "ticks";
    every.value = "10";
    every.range = {1.0, 1e9};
    every.description = "Ticks from one place to the next.";
    swarmanoid::PluginDescription description;
    description.label = "relocation";
    description.summary = "Puts an entity at random places.";
    description.parameters = {entity, every};
    return description;
  }

  void configure(const Configuration& parameters) override {
    entity_ = parameters.text("entity");
    every_ = static_cast<std::uint64_t>(parameters.integer("every"));
    moves_ = &addMetric("moves", "", "How often it was put elsewhere.");
  }

  void reset(const Space&, InterventionQueue&) override { last_placed_ = 0; }

  void afterTick(const Space& space, InterventionQueue& queue) override {
    const swarmanoid::Row row = space.entities.find(entity_);
    if (row == swarmanoid::kNoRow) {
      return;  // deleted or not yet spawned
    }
    if (space.placed[row] > last_placed_) {  // the move requested after the last tick was applied
      last_placed_ = space.placed[row];
      moves_->value += 1.0;
    }
    if (space.tick % every_ == 0) {
      swarmanoid::Pose pose = space.entities.pose[row];
      pose.position.x() = random().uniform(space.corner.x(), space.farCorner().x());
      pose.position.y() = random().uniform(space.corner.y(), space.farCorner().y());
      queue.tryTo(swarmanoid::MoveEntity{entity_, pose});  // fails if the place is occupied
    }
  }

  void archive(swarmanoid::StateArchive& state) override { state(last_placed_); }

 private:
  std::string entity_;
  std::uint64_t every_ = 1;
  std::uint64_t last_placed_ = 0;
  swarmanoid::Metric* moves_ = nullptr;
};

REGISTER_RULE(Relocation)
