// A footbot that forages on a battery: it carries preys to the nest, with blue light, and at a low charge visits a
// perch, with magenta light, after it has delivered its prey.
#include "perch_visit.hpp"
#include "prey_retrieval.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

class FootbotBatteryForaging final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    wheels_ = &robot.actuator<FootbotWheels>();
    const double speed = parameters.number("speed", 0.15, {0.01, 0.3});
    retrieval_.init(robot, parameters, speed);
    visit_.init(robot, parameters, speed, {colors::kCyan, colors::kOrange, colors::kMagenta});
    std::vector<NamedColor> all = retrieval_.colors();
    for (const NamedColor& color : visit_.colors()) {
      all.push_back(color);
    }
    refuseEqualColors(parameters, all);
    parameters.refuseUnread(
        {"speed", "prey_color", "nest_color", "little", "plenty", "free_color", "taken_color", "charging_color"});
    reset();
  }

  void reset() override {
    *wheels_ = FootbotWheels{};
    visit_.reset();
    retrieval_.begin();
  }

  void step(Time, Duration duration) override {
    const double dt = toSeconds(duration);
    visit_.update(dt);
    if (visit_.isUnderWay()) {
      visit_.step();
      if (!visit_.isUnderWay()) {
        retrieval_.begin();
      }
    } else if (visit_.isDue() && retrieval_.isSearching()) {
      visit_.begin();
    } else {
      retrieval_.step(dt);
    }
  }

  void archive(StateArchive& state) override { state(retrieval_, visit_); }

 private:
  FootbotWheels* wheels_ = nullptr;
  PreyRetrieval retrieval_;
  PerchVisit visit_;
};

}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::FootbotBatteryForaging, "footbot_battery_foraging")
