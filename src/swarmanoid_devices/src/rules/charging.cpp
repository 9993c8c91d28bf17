// Charging: robots drain a store of their own, and perches beside which they stand fill it. What perches hold is their
// property, which anybody may read and change; what robots have left is of this rule, as no device tells them.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../parameters.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

constexpr const char* kCharge = "charge";  // J, of whatever charges robots
constexpr const char* kSupply = "supply";  // W, at which that is charged itself

class Charging final : public Rule {
 public:
  static PluginDescription describe();
  void configure(const Configuration& parameters) override;

  void reset(const Space&, InterventionQueue&) override {
    batteries_.clear();
    perches_.clear();
  }

  /// All that perches do is done at once, so that nothing that somebody else changes in between is lost.
  void beforeTick(const Space& space, InterventionQueue& queue) override {
    enlist(space);
    const auto ticks =
        std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(interval_ / toSeconds(space.clocktick))));
    if (space.tick % ticks != 0) {
      return;
    }
    const double elapsed = space.tick == 0 ? 0.0 : static_cast<double>(ticks) * toSeconds(space.clocktick);
    for (Perch& perch : perches_) {
      work(space, perch, elapsed, queue);
    }
    for (Battery& battery : batteries_) {
      if (battery.is_empty && battery.level >= enough_) {
        battery.is_empty = false;
        queue.ask(SetCommandSource{space.entities.name[space.entities.find(battery.robot)], source_});
      }
    }
    measure();
  }

  void afterTick(const Space& space, InterventionQueue& queue) override {
    enlist(space);
    for (Battery& battery : batteries_) {
      drain(space, battery, queue);
    }
    measure();
  }

 private:
  struct Battery {
    EntityNumber robot = kNoEntity;
    double level = 0.0;     // J
    bool is_empty = false;  // nobody commands the robot
  };

  struct Perch {
    EntityNumber number = kNoEntity;
    EntityNumber occupant = kNoEntity;  // the robot that it charges
    bool is_empty = false;              // it gives nothing until it holds enough again
  };

  /// Forgets who is no more, and takes up who is new. Numbers only grow, so the lists stay sorted by them.
  void enlist(const Space& space) {
    const Entities& entities = space.entities;
    const auto is_gone = [&entities](EntityNumber number) { return entities.find(number) == kNoRow; };
    batteries_.erase(std::remove_if(batteries_.begin(), batteries_.end(),
                                    [&](const Battery& battery) { return is_gone(battery.robot); }),
                     batteries_.end());
    perches_.erase(
        std::remove_if(perches_.begin(), perches_.end(), [&](const Perch& perch) { return is_gone(perch.number); }),
        perches_.end());
    for (const Row row : entities.order) {
      const EntityNumber number = entities.number[row];
      if (isCharged(space, row) && (batteries_.empty() || batteries_.back().robot < number)) {
        batteries_.push_back({number, first_level_ * capacity_, false});
      }
      const bool is_perch = !entities.model[row]->is_robot && entities.model[row]->findProperty(kCharge) >= 0;
      if (is_perch && (perches_.empty() || perches_.back().number < number)) {
        perches_.push_back({number, kNoEntity, false});
      }
    }
  }

  /// Whether the rule keeps a battery of that robot. One without a controller is commanded by nobody anyway.
  bool isCharged(const Space& space, Row row) const {
    return space.entities.model[row]->is_robot && space.controllers[row].description != nullptr &&
           space.entities.name[row].compare(0, robot_.size(), robot_) == 0;
  }

  void drain(const Space& space, Battery& battery, InterventionQueue& queue) {
    const Row row = space.entities.find(battery.robot);
    if (battery.is_empty) {
      stop(space, row, queue);  // whatever somebody else has asked for
      return;
    }
    const Twist& twist = space.entities.twist[row];
    constexpr double kStill = 1e-3;       // m/s
    constexpr double kNotTurning = 1e-2;  // rad/s
    const bool is_still = twist.linear.norm() <= kStill && twist.angular.norm() <= kNotTurning;
    const double needed = (is_still ? still_power_ : moving_power_) * toSeconds(space.clocktick);
    const double taken = std::min(needed, battery.level);
    battery.level -= taken;
    drained_->value += taken;
    if (battery.level <= 0.0) {
      battery.is_empty = true;
      ran_empty_->value += 1.0;
      stop(space, row, queue);
    }
  }

  /// Changes nothing if nobody commands it already. It may be deleted before.
  static void stop(const Space& space, Row row, InterventionQueue& queue) {
    queue.tryTo(SetCommandSource{space.entities.name[row], CommandSource::kNone});
  }

  /// @param elapsed since it worked last [s]
  void work(const Space& space, Perch& perch, double elapsed, InterventionQueue& queue) {
    const Row row = space.entities.find(perch.number);
    const double before = *space.property(row, kCharge);
    const double most = chargeRangeOf(space, row).maximum;
    double charge = std::min(before + space.property(row, kSupply).value_or(0.0) * elapsed, most);
    supplied_->value += charge - before;
    perch.is_empty = perch.is_empty && charge < std::min(ready_, most);
    Battery* occupant = perch.is_empty ? nullptr : occupantOf(space, perch, row);
    perch.occupant = occupant == nullptr ? kNoEntity : occupant->robot;
    if (occupant != nullptr) {
      const double given = std::min({power_ * elapsed, capacity_ - occupant->level, charge});
      charge -= given;
      occupant->level += given;
      given_->value += given;
    }
    perch.is_empty = perch.is_empty || charge <= 0.0;
    if (charge != before) {
      queue.ask(SetProperty{space.entities.name[row], kCharge, numberText(charge)});
    }
    signal(space, perch, row, queue);
  }

  static Range chargeRangeOf(const Space& space, Row row) {
    const EntityModel& model = *space.entities.model[row];
    return model.properties[static_cast<std::size_t>(model.findProperty(kCharge))].range;
  }

  /// The robot that the perch charges already, while that stays; else the first that no other one charges.
  Battery* occupantOf(const Space& space, const Perch& perch, Row row) {
    Battery* first = nullptr;
    for (Battery& battery : batteries_) {
      if (!isWithinReach(space, row, battery)) {
        continue;
      }
      if (battery.robot == perch.occupant) {
        return &battery;
      }
      const bool is_elsewhere = std::any_of(perches_.begin(), perches_.end(), [&](const Perch& other) {
        return &other != &perch && other.occupant == battery.robot;
      });
      first = first == nullptr && !is_elsewhere ? &battery : first;
    }
    return first;
  }

  bool isWithinReach(const Space& space, Row perch, const Battery& battery) const {
    const Eigen::Vector3d& robot = space.entities.pose[space.entities.find(battery.robot)].position;
    return (robot - space.entities.pose[perch].position).head<2>().norm() <= reach_;
  }

  void signal(const Space& space, const Perch& perch, Row row, InterventionQueue& queue) const {
    if (!space.entities.model[row]->hasColor()) {
      return;
    }
    const Color color = perch.is_empty ? empty_color_ : perch.occupant != kNoEntity ? taken_color_ : free_color_;
    if (color != space.entities.color[row]) {
      queue.ask(SetProperty{space.entities.name[row], kColorProperty, toString(color)});
    }
  }

  void measure() {
    double sum = 0.0;
    double empty = 0.0;
    for (const Battery& battery : batteries_) {
      sum += battery.level;
      empty += battery.is_empty ? 1.0 : 0.0;
    }
    mean_level_->value = batteries_.empty() ? 0.0 : sum / static_cast<double>(batteries_.size());
    empty_->value = empty;
  }

  std::string robot_;
  double capacity_ = 0.0;      // J, of a robot
  double first_level_ = 1.0;   // of capacity_
  double moving_power_ = 0.0;  // W
  double still_power_ = 0.0;   // W
  double power_ = 0.0;         // W, that a perch gives
  double reach_ = 0.0;         // m
  double interval_ = 1.0;      // s
  double enough_ = 0.0;        // J, with which a robot goes on that was empty
  double ready_ = 0.0;         // J, with which a perch gives again that was empty
  CommandSource source_ = CommandSource::kController;
  Color free_color_;
  Color taken_color_;
  Color empty_color_;
  Metric* mean_level_ = nullptr;
  Metric* empty_ = nullptr;
  Metric* ran_empty_ = nullptr;
  Metric* drained_ = nullptr;
  Metric* given_ = nullptr;
  Metric* supplied_ = nullptr;
  std::vector<Battery> batteries_;
  std::vector<Perch> perches_;
};

PluginDescription Charging::describe() {
  using Type = Parameter::Type;
  constexpr Range kEnergy{0.0, 1e9};
  constexpr Range kPower{0.0, 1e6};
  const auto color = [](const std::string& name, const std::string& value, const std::string& text) {
    return makeParameter(name, Type::kColor, "", value, {}, text);
  };
  Parameter source =
      makeParameter("source", Type::kChoice, "", "controller", {}, "Who commands a robot again that was empty.");
  source.choices = {"controller", "remote", "topics"};
  PluginDescription description;
  description.label = "charging";
  description.summary = "Drains robots, and charges them beside perches; empty ones stop.";
  description.parameters = {
      makeParameter("robot", Type::kText, "", "", {}, "What the names of the robots begin with; empty: all."),
      number("capacity", "J", "1000", {1e-6, 1e9}, "The most that a robot holds."),
      number("first_level", "", "1", {0.0, 1.0}, "Part of it that a robot has at first."),
      number("moving_power", "W", "10", kPower, "That a robot takes while it drives, turns or flies."),
      number("still_power", "W", "1", kPower, "That it takes while it stands still."),
      number("power", "W", "50", kPower, "That a perch gives to a robot."),
      number("reach", "m", "0.3", {0.0, 100.0}, "Between the origins of robot and perch, seen from above."),
      number("interval", "s", "1", {0.001, 3600.0}, "From one time that perches give to the next."),
      number("enough", "", "0.3", {0.001, 1.0}, "Part of it with which one that was empty is commanded again."),
      number("ready", "J", "200", kEnergy, "With which a perch that was empty gives again."),
      color("free_color", "green", "Of a perch that charges no robot."),
      color("taken_color", "yellow", "Of one that charges a robot."),
      color("empty_color", "red", "Of one that was empty, until it is ready."),
      source};
  return description;
}

void Charging::configure(const Configuration& parameters) {
  robot_ = parameters.text("robot");
  capacity_ = parameters.number("capacity");
  first_level_ = parameters.number("first_level");
  moving_power_ = parameters.number("moving_power");
  still_power_ = parameters.number("still_power");
  power_ = parameters.number("power");
  reach_ = parameters.number("reach");
  interval_ = parameters.number("interval");
  enough_ = parameters.number("enough") * capacity_;
  ready_ = parameters.number("ready");
  source_ = *parseCommandSource(parameters.text("source"));
  free_color_ = parameters.color("free_color");
  taken_color_ = parameters.color("taken_color");
  empty_color_ = parameters.color("empty_color");
  mean_level_ = &addMetric("mean_level", "J", "What a robot has left, in the mean over the robots.");
  empty_ = &addMetric("empty", "", "Robots that are empty now, and wait for charge.");
  ran_empty_ = &addMetric("ran_empty", "", "How often a robot ran empty.");
  drained_ = &addMetric("drained", "J", "What robots have used.");
  given_ = &addMetric("given", "J", "What perches have given to robots.");
  supplied_ = &addMetric("supplied", "J", "What perches have been charged with.");
}

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Charging)
