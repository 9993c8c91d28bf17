// The robots that packages bring, as entity types of <arena>; what else stands there is in arena_objects/.
#include <string>
#include <utility>

#include "../xml/xml_document.hpp"
#include "robot_description.hpp"
#include "robot_files.hpp"
#include "swarmanoid_space/models/entity_type.hpp"

namespace swarmanoid {
namespace {

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

}  // namespace
}  // namespace swarmanoid

namespace {
const bool are_robot_types_registered = swarmanoid::registerRobotTypes();
}
