// Path length of an entity: writes a line per tick to a file and a result of the run, and ends the run at a goal.
#include <cstdio>

#include "swarmanoid_recording/output/out_file.hpp"

using swarmanoid::Configuration;
using swarmanoid::Parameter;
using swarmanoid::Space;

class Odometer final : public swarmanoid::Observer {
 public:
  static swarmanoid::PluginDescription describe() {
    Parameter entity;
    entity.name = "entity";
    entity.description = "Whose way is measured.";
    Parameter file;
    file.name = "file";
    file.description = "Where the lines go: tick, metres.";
    Parameter goal;
    goal.name = "goal";
    goal.type = Parameter::Type::kNumber;
    goal.unit = "m";
    goal.value = "0";
    goal.range = {0.0, swarmanoid::kInfinity};
    goal.description = "The run ends when the entity has gone so far; 0: it does not.";
    swarmanoid::PluginDescription description;
    description.label = "odometer";
    description.summary = "Measures how far an entity goes.";
    description.parameters = {entity, file, goal};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters,
                 const swarmanoid::RunContext& context) override {
    id_ = id;
    entity_ = parameters.text("entity");
    goal_ = parameters.number("goal", 0.0);
    file_.open(context, parameters, id);
  }

  void draw(const Space& space) override {
    const swarmanoid::Row row = space.entities.find(entity_);
    if (row == swarmanoid::kNoRow) {
      return;  // deleted or not yet spawned
    }
    const Eigen::Vector3d& position = space.entities.pose[row].position;
    travelled_ += is_under_way_ ? (position - last_position_).norm() : 0.0;
    last_position_ = position;
    is_under_way_ = true;
    char line[64];
    std::snprintf(line, sizeof line, "%llu %.6f\n", static_cast<unsigned long long>(space.tick), travelled_);
    file_ << line;
  }

  bool terminate() const override { return goal_ > 0.0 && travelled_ >= goal_; }
  void addMetrics(swarmanoid::Metrics& metrics) const override { metrics[id_ + "_m"] = travelled_; }

  void reset() override {
    file_.restart();
    travelled_ = 0.0;
    is_under_way_ = false;
  }

  void flush() override { file_.flush(); }
  void finish() override { file_.flush(); }

 private:
  std::string entity_;
  swarmanoid::OutFile file_;
  double goal_ = 0.0;       // [m]
  double travelled_ = 0.0;  // [m]
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
  bool is_under_way_ = false;
};

REGISTER_OBSERVER(Odometer)
