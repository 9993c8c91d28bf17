// Charging: perches charge robots that stand beside them, or that hold on to them. The charges of perches and robots
// are properties, which can be read and set from outside; the battery model computes what robots use.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "batteries.hpp"
#include "common/parameters.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {
namespace {

class Charging final : public Rule {
 public:
  static PluginDescription describe();
  void configure(const Configuration& parameters) override;

  void reset(const Space&, InterventionQueue&) override {
    batteries_.clear();
    perches_.clear();
  }

  void beforeTick(const Space& space, InterventionQueue& queue) override {
    updatePerches(space, queue);
    batteries_.updateMembers(space);
    const double dt = toSeconds(space.clocktick);
    const auto ticks = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(interval_ / dt)));
    if (space.tick % ticks == 0) {
      const double interval = static_cast<double>(ticks) * dt;
      for (Perch& perch : perches_) {
        work(space, perch, interval, queue);
      }
    }
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    batteries_.updateMembers(space);  // later rules may have deleted some
    batteries_.measure(space);
  }

  void archive(StateArchive& state) override { state(batteries_, perches_); }

 private:
  struct Perch {
    EntityNumber number = kNoEntity;
    EntityNumber occupant = kNoEntity;  // the robot that the perch charges
    double received = 0.0;              // J, received by the occupant from all sources, at the last payment
    bool is_empty = false;              // gives nothing until its charge is `ready` again
  };

  void updatePerches(const Space& space, InterventionQueue& queue) {
    const Entities& entities = space.entities;
    for (Perch& perch : perches_) {
      if (entities.find(perch.number) == kNoRow) {
        release(space, perch, queue);
      }
    }
    const auto is_perch = [&](Row row) {
      return !entities.model[row]->is_robot && entities.model[row]->findProperty(kCharge) >= 0;
    };
    updateMembers(space, entities.order, is_perch, perches_);
  }

  static void release(const Space& space, Perch& perch, InterventionQueue& queue) {
    const Row robot = space.entities.find(perch.occupant);
    perch.occupant = kNoEntity;
    if (robot != kNoRow) {
      queue.ask(SetProperty{space.entities.name[robot], kSupply, "0"});
    }
  }

  /// Pays for the energy that the occupant has received, and selects the robot to charge until the next interval.
  void work(const Space& space, Perch& perch, double interval, InterventionQueue& queue) {
    const Row row = space.entities.find(perch.number);
    const double before = *space.property(row, kCharge);
    const double most = chargeRangeOf(space, row).maximum;
    double charge = pay(space, perch, before);
    perch.is_empty = perch.is_empty || charge <= 0.0;
    if (space.tick > 0) {
      const double fed = std::min(charge + space.property(row, kSupply).value_or(0.0) * interval, most);
      supplied_->value += fed - charge;
      charge = fed;
    }
    perch.is_empty = perch.is_empty && charge < std::min(ready_, most);
    if (charge != before) {
      queue.ask(SetProperty{space.entities.name[row], kCharge, numberText(charge)});
    }
    const Row occupant = perch.is_empty ? kNoRow : occupantOf(space, perch, row);
    if (perch.occupant != kNoEntity &&
        (occupant == kNoRow || space.entities.number[occupant] != perch.occupant)) {  // it may have been deleted
      release(space, perch, queue);
    }
    if (occupant != kNoRow) {
      perch.occupant = space.entities.number[occupant];
      perch.received = space.batteries[occupant][0].received;
      const std::string power = numberText(std::min(power_, charge / interval));
      queue.ask(SetProperty{space.entities.name[occupant], kSupply, power});
    }
    signal(space, perch, row, queue);
  }

  /// Subtracts the energy given to the occupant. @return remaining charge of the perch [J]
  double pay(const Space& space, const Perch& perch, double charge) {
    constexpr double kNothing = 1e-9;  // J: rounding error
    const Row robot = space.entities.find(perch.occupant);
    if (robot == kNoRow) {
      return charge;
    }
    const double given = space.batteries[robot][0].received - perch.received;
    given_->value += given;
    return charge - given > kNothing ? charge - given : 0.0;
  }

  static Range chargeRangeOf(const Space& space, Row row) {
    const EntityModel& model = *space.entities.model[row];
    return model.properties[static_cast<std::size_t>(model.findProperty(kCharge))].range;
  }

  /// The robot that the perch already charges, while it stays within reach; else the first that no other perch charges.
  Row occupantOf(const Space& space, const Perch& perch, Row row) const {
    Row first = kNoRow;
    for (const Batteries::Robot& robot : batteries_.all()) {
      const Row candidate = space.entities.find(robot.number);
      if (!isWithinReach(space, row, candidate)) {
        continue;
      }
      if (robot.number == perch.occupant) {
        return candidate;
      }
      const bool is_elsewhere = std::any_of(perches_.begin(), perches_.end(),
                                            [&](const Perch& other) { return other.occupant == robot.number; });
      first = first == kNoRow && !is_elsewhere ? candidate : first;
    }
    return first;
  }

  /// Ferromagnetic perches charge robots that hold on to them, such as eyebots under the ceiling.
  bool isWithinReach(const Space& space, Row perch, Row robot) const {
    if (space.entities.model[perch]->is_ferromagnetic) {
      bool holds = false;
      space.attachments.visit(robot, [&](std::size_t, const Attachment& held) { holds = holds || held.held == perch; });
      return holds;
    }
    const Eigen::Vector3d way = space.entities.pose[robot].position - space.entities.pose[perch].position;
    return way.head<2>().norm() <= reach_;
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

  double power_ = 0.0;     // W, given by a perch
  double reach_ = 0.0;     // m
  double interval_ = 1.0;  // s
  double ready_ = 0.0;     // J, charge at which an empty perch gives again
  Color free_color_;
  Color taken_color_;
  Color empty_color_;
  Metric* given_ = nullptr;
  Metric* supplied_ = nullptr;
  Batteries batteries_;
  std::vector<Perch> perches_;
};

PluginDescription Charging::describe() {
  using Type = Parameter::Type;
  const auto color = [](const std::string& name, const std::string& value, const std::string& text) {
    return makeParameter(name, Type::kColor, "", value, {}, text);
  };
  PluginDescription description;
  description.label = "charging";
  description.summary = "Charges robots beside perches, or attached under them.";
  description.parameters = {
      makeParameter("robot", Type::kText, "", "", {}, "Name prefix of the robots; empty: all."),
      number("power", "W", "50", kPowerRange, "That a perch gives to a robot."),
      number("reach", "m", "0.3", {0.0, 100.0}, "Between the origins of robot and perch, seen from above."),
      number("interval", "s", "1", {0.001, 3600.0}, "Time between two searches for robots at perches."),
      number("ready", "J", "200", kChargeRange, "Charge at which an empty perch resumes charging."),
      color("free_color", "green", "Of a perch that charges no robot."),
      color("taken_color", "yellow", "Of one that charges a robot."),
      color("empty_color", "red", "Of one that was empty, until it is ready.")};
  return description;
}

void Charging::configure(const Configuration& parameters) {
  power_ = parameters.number("power");
  reach_ = parameters.number("reach");
  interval_ = parameters.number("interval");
  ready_ = parameters.number("ready");
  free_color_ = parameters.color("free_color");
  taken_color_ = parameters.color("taken_color");
  empty_color_ = parameters.color("empty_color");
  const auto add = [this](const std::string& name, const std::string& unit, const std::string& text) -> Metric& {
    return addMetric(name, unit, text);
  };
  batteries_.configure(parameters.text("robot"), add);
  given_ = &addMetric("given", "J", "Energy that perches have given to robots.");
  supplied_ = &addMetric("supplied", "J", "Energy supplied to perches.");
}

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Charging)
