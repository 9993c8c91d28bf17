// The entity types of <arena>: the robots that packages bring, and what else stands in an arena.
#include <array>
#include <map>
#include <mutex>
#include <string>

#include "../xml/xml_document.hpp"
#include "robot_description.hpp"
#include "robot_files.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

Parameter parameter(const std::string& name, Parameter::Type type, const std::string& unit,
                    const std::string& description, std::optional<std::string> value = std::nullopt) {
  const bool is_length = type == Parameter::Type::kNumber || type == Parameter::Type::kVector3;
  return makeParameter(name, type, unit, std::move(value), is_length ? limits::kLength : Range{}, description);
}

Parameter mass(const std::string& value, double least, const std::string& description) {
  Parameter result = parameter("mass", Parameter::Type::kNumber, "kg", description, value);
  result.range = {least, limits::kMass.maximum};
  return result;
}

/// Models of equal parameters are one object, which keeps memory small and comparisons cheap.
template <class Key, class Make>
std::shared_ptr<const EntityModel> shared(std::map<Key, std::weak_ptr<const EntityModel>>& known, const Key& key,
                                          Make make) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<const EntityModel> model = known[key].lock();
  if (!model) {
    model = make();
    known[key] = model;
  }
  return model;
}

class RobotType final : public EntityType {
 public:
  explicit RobotType(std::string name) : name_(std::move(name)) {}
  std::shared_ptr<const EntityModel> makeModel(const Configuration&) const override { return robotModel(name_); }
  bool isRobot() const override { return true; }

 private:
  std::string name_;
};

/// @return "" where the description is wrong; robotModel says what is wrong to whoever uses the robot
std::string summaryOf(const RobotFile& robot) {
  try {
    const XmlDocument document = parseXml(readTextFile(robot.file), robot.file, XmlNamespaces::kAllowed);
    return readRobotDescription(*document, robot.file).summary;
  } catch (const ConfigError&) {
    return "";
  }
}

/// Registers a type for each robot that a package brings. Of two of a name the second is a conflict in the registry,
/// and whoever uses the name is refused.
bool registerRobotTypes() {
  for (const RobotFile& robot : robotFiles().robots) {
    PluginDescription description;
    description.label = robot.type;
    description.summary = summaryOf(robot);
    Registry::instance().add(PluginKind::kEntity, description, [type = robot.type]() -> std::shared_ptr<void> {
      return std::static_pointer_cast<EntityType>(std::make_shared<RobotType>(type));
    });
  }
  return true;
}

class BlockType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "block";
    description.summary = "A brick: a wall, an obstacle, a table. Its position is its centre.";
    description.parameters = {
        parameter("size", Parameter::Type::kVector3, "m", "Lengths along the brick's own x, y, z."),
        mass("0", 0.0, "Of the brick, at least 0.001; 0: it is fixed to the ground."),
        parameter("ferromagnetic", Parameter::Type::kBoolean, "", "Whether magnets hold on it.", "false")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const Eigen::Vector3d size = parameters.vector3("size");
    if (!(size.minCoeff() > 0.0)) {
      throw ConfigError(parameters.find("size")->location(),
                        "size: found '" + parameters.text("size") + "', allowed: three numbers greater than 0");
    }
    const double mass = parameters.number("mass", 0.0);
    if (mass != 0.0 && !limits::kMass.contains(mass)) {
      throw ConfigError(
          parameters.find("mass")->location(),
          "mass: found '" + parameters.text("mass") + "', allowed: 0, or a number " + limits::kMass.toString());
    }
    const bool is_ferromagnetic = parameters.boolean("ferromagnetic", false);
    using Key = std::array<double, 5>;
    static std::map<Key, std::weak_ptr<const EntityModel>> known;
    return shared(known, Key{size.x(), size.y(), size.z(), mass, is_ferromagnetic ? 1.0 : 0.0},
                  [&] { return blockModel(size, mass, is_ferromagnetic); });
  }
};

class CylindricPreyType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "cylindric_prey";
    description.summary = "A target object with a gripping strip. Its position is the middle of its lower face.";
    description.parameters = {parameter("radius", Parameter::Type::kNumber, "m", "Of the cylinder."),
                              parameter("height", Parameter::Type::kNumber, "m", "Of the cylinder."),
                              mass("0.3", limits::kMass.minimum, "Of the prey."),
                              parameter("color", Parameter::Type::kColor, "", "As cameras see it.", "white")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    using Key = std::array<double, 3>;
    static std::map<Key, std::weak_ptr<const EntityModel>> known;
    const double radius = parameters.number("radius");
    const double height = parameters.number("height");
    const double mass = parameters.number("mass", kPreyMass);
    return shared(known, Key{radius, height, mass}, [&] { return cylindricPreyModel(radius, height, mass); });
  }
};

class LightType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "light";
    description.summary = "A lamp that cameras see; it has no body.";
    description.parameters = {parameter("color", Parameter::Type::kColor, "", "Of its light.", "white")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration&) const override { return lightModel(); }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::BlockType)
REGISTER_ENTITY_TYPE(swarmanoid::CylindricPreyType)
REGISTER_ENTITY_TYPE(swarmanoid::LightType)

namespace {
const bool are_robot_types_registered = swarmanoid::registerRobotTypes();
}
