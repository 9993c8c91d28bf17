// Robots of installed packages as entity types of <arena>; other types are in arena_objects/.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "robot_description.hpp"
#include "robot_files.hpp"
#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_experiment_files/xml/xml_document.hpp"
#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

/// Battery parameters that elements of <arena> may set, by their names there.
struct BatteryNumber {
  const char* name;
  double BatteryModel::*value;
};
constexpr BatteryNumber kBatteryNumbers[] = {{"battery_capacity", &BatteryModel::capacity},
                                             {"battery_level", &BatteryModel::first_share},
                                             {"battery_capacitor", &BatteryModel::capacitor},
                                             {"battery_enough", &BatteryModel::enough},
                                             {"battery_stall", &BatteryModel::stall}};

/// Refuses battery parameters without a battery, where they have no effect. Default values are accepted, because they
/// were filled in before.
void refuseBatteryNumbers(const Configuration& parameters, const BatteryModel& usual) {
  for (const auto& [name, value] : kBatteryNumbers) {
    const Configuration* given = parameters.find(name);
    if (given != nullptr && parameters.number(name) != usual.*value) {
      throw ConfigError(given->location(),
                        std::string(name) + ": found '" + given->text() +
                            "' for a robot without a battery, allowed: with <battery>true</battery>, or " +
                            numberText(usual.*value));
    }
  }
}

class RobotType final : public EntityType {
 public:
  explicit RobotType(std::string name) : name_(std::move(name)) {}

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    std::shared_ptr<const EntityModel> robot = robotModel(name_);
    if (!robot->possible_battery) {
      return robot;
    }
    BatteryModel battery = *robot->possible_battery;
    if (!parameters.boolean("battery", false)) {
      refuseBatteryNumbers(parameters, battery);
      return robot;
    }
    for (const auto& [name, value] : kBatteryNumbers) {
      battery.*value = parameters.number(name, battery.*value);
    }
    using Key = std::pair<std::string, std::array<double, 5>>;
    static SharedModels<Key> models;
    return models.get(
        {name_, {battery.capacity, battery.capacitor, battery.first_share, battery.enough, battery.stall}},
        [&] { return robotWithBattery(*robot, battery); });
  }

  bool isRobot() const override { return true; }

 private:
  std::string name_;
};

/// Parameters in <arena> for the battery of a robot that can have one.
std::vector<Parameter> batteryParameters(const BatteryModel& battery) {
  using Type = Parameter::Type;
  return {makeParameter("battery", Type::kBoolean, "", "false", {},
                        "Whether it runs on a battery; else its energy is unlimited."),
          makeParameter("battery_capacity", Type::kNumber, "J", numberText(battery.capacity), kCapacityRange,
                        "Maximum charge of the battery."),
          makeParameter("battery_level", Type::kNumber, "", numberText(battery.first_share), {0.0, 1.0},
                        "Initial charge, as a part of the maximum."),
          makeParameter("battery_capacitor", Type::kNumber, "J", numberText(battery.capacitor), kChargeRange,
                        "Of the super-capacitor that keeps it alive while the battery is out."),
          makeParameter("battery_enough", Type::kNumber, "", numberText(battery.enough), {0.001, 1.0},
                        "Part of the capacity at which it resumes after it was empty."),
          makeParameter("battery_stall", Type::kNumber, "W", numberText(battery.stall), kPowerRange,
                        "Of both wheels' motors, stalled at full voltage; 0: load draws no power.")};
}

/// Returns an empty description if the file has mistakes; robotModel reports them when the robot is used.
RobotDescription descriptionOf(const RobotFile& robot) {
  try {
    const XmlDocument document = parseXml(readUrdfText(robot.file), robot.file, XmlNamespaces::kAllowed);
    return readRobotDescription(*document, robot.file);
  } catch (const ConfigError&) {
    return {};
  }
}

/// Registers a type for each robot of a package. The second of two robots with one name is a conflict in the registry,
/// and experiments that use the name are refused.
bool registerRobotTypes() {
  for (const RobotFile& robot : robotFiles().robots) {
    PluginDescription description;
    description.label = robot.type;
    const RobotDescription known = descriptionOf(robot);
    description.summary = known.summary;
    if (known.battery) {
      description.parameters = batteryParameters(*known.battery);
    }
    Registry::instance().add(PluginKind::kEntity, description, [type = robot.type]() -> std::shared_ptr<void> {
      return std::static_pointer_cast<EntityType>(std::make_shared<RobotType>(type));
    });
  }
  return true;
}

}  // namespace
}  // namespace swarmanoid

namespace {
const bool are_robot_types_registered = swarmanoid::registerRobotTypes();
}
