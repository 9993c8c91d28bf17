#include "urdf_checks.hpp"

#include <Eigen/Eigenvalues>

#include "robot_joints.hpp"
#include "swarmanoid_experiment_files/xml/xml_node.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

std::string massText(double mass) {
  constexpr int kDigits = 7;
  return shortNumber(mass, kDigits);
}

class UrdfChecks {
 public:
  explicit UrdfChecks(const UrdfFile& urdf) : urdf_(urdf) {}

  std::vector<ConfigError> run() {
    const xmlNode& robot = *xmlDocGetRootElement(urdf_.document.get());
    for (const xmlNode* element : elementsOf(robot)) {
      const std::string name = attributeOf(*element, "name").value_or("");
      if (nameOf(*element) == "joint") {
        checkJoint(*element, name);
      } else if (const urdf::LinkConstSharedPtr link = urdf_.robot->getLink(name);
                 nameOf(*element) == "link" && link != nullptr && link->inertial != nullptr) {
        checkInertial(*childOf(*element, "inertial"), name, *link->inertial);
      }
    }
    // a robot without mass can be used where there are no forces
    if (mass_ > 0.0 && !limits::kMass.contains(mass_)) {
      mistakes_.emplace_back(
          SourceLocation{urdf_.file, 0},
          "found a mass of " + massText(mass_) + " kg in all links, allowed: " + limits::kMass.toString());
    }
    return std::move(mistakes_);
  }

 private:
  void refuse(const xmlNode& element, const std::string& message) {
    mistakes_.emplace_back(SourceLocation{urdf_.file, lineOf(&element)}, message);
  }

  void checkJoint(const xmlNode& element, const std::string& name) {
    static const std::vector<std::string> kTypes{"fixed", "revolute", "continuous"};
    const std::string type = attributeOf(element, "type").value_or("");
    if (!contains(kTypes, type)) {
      refuse(element, "joint '" + name + "': found the type '" + type + "', allowed: " + joinNames(kTypes));
    }
    const urdf::JointConstSharedPtr joint = urdf_.robot->getJoint(name);
    if (joint != nullptr && isTurningJoint(*joint) && joint->axis.x == 0.0 && joint->axis.y == 0.0 &&
        joint->axis.z == 0.0) {
      refuse(element, "joint '" + name + "': found the axis 0 0 0, allowed: a direction");
    }
    if (const xmlNode* mimic = childOf(element, "mimic")) {
      refuse(*mimic, "joint '" + name + "': found <mimic>, allowed: joints that follow no other one");
    }
  }

  void checkInertial(const xmlNode& element, const std::string& name, const urdf::Inertial& inertial) {
    if (!(inertial.mass >= 0.0 && inertial.mass <= limits::kMass.maximum)) {
      refuse(element, "link '" + name + "': found a mass of " + massText(inertial.mass) +
                          " kg, allowed: " + Range{0.0, limits::kMass.maximum}.toString());
    } else {
      mass_ += inertial.mass;
    }
    // in ascending order
    const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertiaOf(inertial)).eigenvalues();
    constexpr double kRounding = 0.01;  // of files with few digits
    if (!(moments[0] >= -kRounding * moments[2] && moments[2] <= (1.0 + kRounding) * (moments[0] + moments[1]))) {
      const xmlNode* place = childOf(element, "inertia");
      PlainTextStream found;
      found << moments.x() << ", " << moments.y() << " and " << moments.z();
      refuse(place == nullptr ? element : *place,
             "link '" + name + "': found the principal moments of inertia " + found.str() +
                 " kg m2, allowed: none below 0, none above the sum of the other two");
    }
  }

  const UrdfFile& urdf_;
  double mass_ = 0.0;  // [kg]
  std::vector<ConfigError> mistakes_;
};

}  // namespace

std::vector<ConfigError> mistakesIn(const UrdfFile& urdf) { return UrdfChecks(urdf).run(); }

}  // namespace swarmanoid
