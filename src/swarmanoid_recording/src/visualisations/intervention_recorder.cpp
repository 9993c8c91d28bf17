// Records the interventions in a run, for playing them into another run.
#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_recording/output/out_file.hpp"

namespace swarmanoid {
namespace {

class InterventionRecorder final : public Observer {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "intervention_recorder";
    description.summary = "Writes interventions from outside or by rules, to be played into another run.";
    description.parameters = {makeParameter("file", Parameter::Type::kText, "", std::nullopt, {},
                                            "Output file, as XML; after a reset it is that of the new run.")};
    return description;
  }

  void configure(const std::string& id, const Configuration& parameters, const RunContext& context) override {
    id_ = id;
    file_.open(context, parameters, id);
    if (context.experiment != nullptr) {
      experiment_ = context.experiment->name;
    }
  }

  void draw(const Space& space) override {
    if (!has_begun_) {
      file_ << interventionsBegin(experiment_, space.seed);
      has_begun_ = true;
    }
    for (const TakenIntervention& taken : space.interventions) {
      file_ << toXml(taken, 1);
    }
    if (!space.interventions.empty()) {
      file_.flush();  // whole elements, so that the file of a killed run lacks only the end
    }
  }

  void flush() override { file_.flush(); }

  void reset() override {
    file_.restart();
    has_begun_ = false;
  }

  void finish() override {
    if (has_begun_) {
      file_ << interventionsEnd();
    }
    file_.flush();
  }

 private:
  OutFile file_;
  std::string experiment_;
  bool has_begun_ = false;
};

}  // namespace
}  // namespace swarmanoid

REGISTER_OBSERVER(swarmanoid::InterventionRecorder)
