// A footbot that forages alone, by the preys and the nest that it sees.
#include "prey_retrieval.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class FootbotForaging final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    retrieval_.init(robot, parameters, parameters.number("speed", 0.15, {0.01, 0.3}));
    refuseEqualColors(parameters, retrieval_.colors());
    parameters.refuseUnread({"speed", "prey_color", "nest_color"});
    reset();
  }

  void reset() override {
    *wheels_ = FootbotWheels{};
    retrieval_.begin();
  }

  void step(Time, Duration dt) override { retrieval_.step(toSeconds(dt)); }

  void archive(StateArchive& state) override { state(retrieval_); }

 private:
  FootbotWheels* wheels_ = nullptr;
  PreyRetrieval retrieval_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::FootbotForaging, "footbot_foraging")
