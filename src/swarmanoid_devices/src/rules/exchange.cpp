// Exchange stations swap the batteries of robots that stand in them: the old one out, a charged one in, while the
// robot's super-capacitor keeps it alive. All batteries are properties of stations and robots, so a battery is lost
// only if a robot or a station is deleted.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "batteries.hpp"
#include "common/parameters.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {
namespace {

constexpr const char* kArm = "arm";                 // J, charge of the battery on its way into a robot
constexpr const char* kFirstBattery = "battery_1";  // J, charge of a battery that waits in the station

class Exchange final : public Rule {
 public:
  static PluginDescription describe();
  void configure(const Configuration& parameters) override;

  void reset(const Space&, InterventionQueue&) override {
    batteries_.clear();
    stations_.clear();
  }

  void beforeTick(const Space& space, InterventionQueue& queue) override {
    batteries_.updateMembers(space);
    updateStations(space);
    // requests take effect after this call; until then the properties of entities whose battery has moved are stale
    bool has_moved = false;
    for (Station& station : stations_) {
      if (station.occupant != kNoEntity) {
        has_moved = goOn(space, station, space.entities.find(station.number), queue) || has_moved;
      }
    }
    for (Station& station : stations_) {
      const Row row = space.entities.find(station.number);
      if (!has_moved && station.occupant == kNoEntity) {
        has_moved = startSwap(space, station, row, queue);
      }
      if (!has_moved && station.uncharged >= interval_ - kRounding) {
        recharge(space, row, station.uncharged, queue);
        station.uncharged = 0.0;
      }
      station.uncharged += toSeconds(space.clocktick);
    }
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    batteries_.updateMembers(space);  // later rules may have deleted some
    batteries_.measure(space);
    swapping_->value = static_cast<double>(std::count_if(
        stations_.begin(), stations_.end(), [](const Station& station) { return station.occupant != kNoEntity; }));
  }

  void archive(StateArchive& state) override { state(batteries_, stations_); }

 private:
  struct Station {
    EntityNumber number = kNoEntity;
    EntityNumber occupant = kNoEntity;  // robot whose battery is being swapped
    std::string slot;                   // property of the slot that its battery has gone to
    double time = 0.0;                  // s, duration of the swap so far, while the robot is within reach
    double uncharged = 0.0;             // s, since its batteries were last charged

    void archive(StateArchive& state) { state(number, occupant, slot, time, uncharged); }
  };

  static constexpr double kRounding = 1e-9;  // s

  void updateStations(const Space& space) {
    const auto is_station = [&](Row row) {
      const EntityModel& model = *space.entities.model[row];
      return model.findProperty(kFirstBattery) >= 0 && model.findProperty(kArm) >= 0;
    };
    updateMembers(space, space.entities.order, is_station, stations_);
  }

  static bool isSlot(const EntityModel::Property& property) { return property.name.rfind("battery_", 0) == 0; }

  static void set(const Space& space, Row row, const std::string& property, double value, InterventionQueue& queue) {
    queue.ask(SetProperty{space.entities.name[row], property, numberText(value)});
  }

  /// Charges the batteries in the station, first the fullest that is not full, so that one is ready soon.
  void recharge(const Space& space, Row row, double elapsed, InterventionQueue& queue) {
    const EntityModel& model = *space.entities.model[row];
    double left = space.property(row, kSupply).value_or(0.0) * elapsed;
    std::vector<double> charges(space.properties[row].begin(), space.properties[row].end());
    while (left > 0.0) {
      std::size_t fullest = charges.size();
      for (std::size_t i = 0; i < charges.size(); ++i) {
        const bool has_room = isSlot(model.properties[i]) && charges[i] < model.properties[i].range.maximum;
        if (has_room && (fullest == charges.size() || charges[i] > charges[fullest])) {
          fullest = i;
        }
      }
      if (fullest == charges.size()) {
        return;
      }
      const double given = std::min(left, model.properties[fullest].range.maximum - charges[fullest]);
      charges[fullest] = std::min(charges[fullest] + given, model.properties[fullest].range.maximum);
      left -= given;
      supplied_->value += given;
      set(space, row, model.properties[fullest].name, charges[fullest], queue);
    }
  }

  /// Starts a swap for the first robot that needs one: its battery goes into the slot of the replacement.
  /// @return whether a swap has started
  bool startSwap(const Space& space, Station& station, Row row, InterventionQueue& queue) {
    if (*space.property(row, kArm) > 0.0) {
      return false;  // the battery on the arm would be lost
    }
    for (const Batteries::Robot& robot : batteries_.all()) {
      const Row candidate = space.entities.find(robot.number);
      const double charge = space.properties[candidate][kBatteryCharge];
      const double capacity = space.entities.model[candidate]->battery->capacity;
      if (charge >= below_ * capacity || !isWithinReach(space, row, candidate) || isServed(robot.number)) {
        continue;
      }
      const int slot = slotFor(space, row, charge, capacity);
      if (slot < 0) {
        continue;
      }
      station.occupant = robot.number;
      station.slot = space.entities.model[row]->properties[static_cast<std::size_t>(slot)].name;
      station.time = 0.0;
      set(space, row, kArm, space.properties[row][static_cast<std::size_t>(slot)], queue);
      set(space, row, station.slot, charge, queue);
      set(space, candidate, kCharge, 0.0, queue);
      return true;
    }
    return false;
  }

  /// The slot with the fullest battery that is ready and fits the robot; -1: none.
  int slotFor(const Space& space, Row row, double charge, double capacity) const {
    const EntityModel& model = *space.entities.model[row];
    int best = -1;
    double most = charge;
    for (std::size_t i = 0; i < model.properties.size(); ++i) {
      const double held = space.properties[row][i];
      const bool fits = held <= capacity && charge <= model.properties[i].range.maximum;
      const bool is_ready = isSlot(model.properties[i]) && held >= ready_ * capacity && fits;
      if (is_ready && held > most) {
        most = held;
        best = static_cast<int>(i);
      }
    }
    return best;
  }

  /// Continues a swap: the battery on the arm goes into the robot, or back into its slot if the robot was deleted.
  /// @return whether a battery has moved
  bool goOn(const Space& space, Station& station, Row row, InterventionQueue& queue) {
    const Row robot = space.entities.find(station.occupant);
    const double charge = *space.property(row, kArm);
    if (robot == kNoRow) {
      set(space, row, station.slot, charge, queue);
      set(space, row, kArm, 0.0, queue);
      station.occupant = kNoEntity;
      return true;
    }
    if (!isWithinReach(space, row, robot)) {
      return false;
    }
    station.time += toSeconds(space.clocktick);
    if (station.time < swap_time_ - kRounding) {
      return false;
    }
    // services may have set a charge on the arm above the robot's capacity
    const double taken = std::min(charge, space.entities.model[robot]->battery->capacity);
    set(space, robot, kCharge, taken, queue);
    set(space, row, kArm, 0.0, queue);
    if (charge > taken) {
      const auto slot = static_cast<std::size_t>(space.entities.model[row]->findProperty(station.slot));
      const double most = space.entities.model[row]->properties[slot].range.maximum;
      set(space, row, station.slot, std::min(space.properties[row][slot] + charge - taken, most), queue);
    }
    station.occupant = kNoEntity;
    swaps_->value += 1.0;
    return true;
  }

  bool isServed(EntityNumber robot) const {
    return std::any_of(stations_.begin(), stations_.end(),
                       [&](const Station& station) { return station.occupant == robot; });
  }

  bool isWithinReach(const Space& space, Row station, Row robot) const {
    const Eigen::Vector3d way = space.entities.pose[robot].position - space.entities.pose[station].position;
    return way.head<2>().norm() <= reach_;
  }

  double reach_ = 0.0;      // m
  double below_ = 0.0;      // part of the capacity
  double ready_ = 0.0;      // part of the capacity
  double swap_time_ = 0.0;  // s
  double interval_ = 0.0;   // s
  Metric* swaps_ = nullptr;
  Metric* swapping_ = nullptr;
  Metric* supplied_ = nullptr;
  Batteries batteries_;
  std::vector<Station> stations_;
};

PluginDescription Exchange::describe() {
  PluginDescription description;
  description.label = "exchange";
  description.summary = "Stations swap the batteries of robots that stand in them.";
  description.parameters = {
      makeParameter("robot", Parameter::Type::kText, "", "", {}, "Name prefix of the robots; empty: all."),
      number("reach", "m", "0.3", {0.0, 100.0}, "Between the origins of robot and station, seen from above."),
      number("below", "", "0.5", {0.0, 1.0}, "Part of the capacity below which a robot's battery is swapped."),
      number("ready", "", "0.95", {0.0, 1.0}, "Part of the capacity that a battery must hold to be given."),
      number("swap_time", "s", "10", {0.0, 3600.0}, "From the old battery's leaving to the new one's being in."),
      number("interval", "s", "1", {0.001, 3600.0}, "Time between two updates of the batteries in stations.")};
  return description;
}

void Exchange::configure(const Configuration& parameters) {
  reach_ = parameters.number("reach");
  below_ = parameters.number("below");
  ready_ = parameters.number("ready");
  swap_time_ = parameters.number("swap_time");
  interval_ = parameters.number("interval");
  const auto add = [this](const std::string& name, const std::string& unit, const std::string& text) -> Metric& {
    return addMetric(name, unit, text);
  };
  batteries_.configure(parameters.text("robot"), add);
  swaps_ = &addMetric("swaps", "", "Batteries that were swapped.");
  swapping_ = &addMetric("swapping", "", "Swaps that are under way.");
  supplied_ = &addMetric("supplied", "J", "Energy supplied to batteries in stations.");
}

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Exchange)
