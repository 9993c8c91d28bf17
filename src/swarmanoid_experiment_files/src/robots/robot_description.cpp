#include "robot_description.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "swarmanoid_experiment_files/xml/xml_document.hpp"
#include "swarmanoid_experiment_files/xml/xml_node.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

using Kind = EntityModel::Holder::Kind;

class Reader {
 public:
  Reader(const xmlDoc& document, const std::string& file) : robot_(*xmlDocGetRootElement(&document)), file_(file) {
    for (const xmlNode* element : elementsOf(robot_)) {
      if (nameOf(*element) == "link") {
        links_.push_back(attributeOf(*element, "name").value_or(""));
      } else if (nameOf(*element) == "joint") {
        joints_.push_back(attributeOf(*element, "name").value_or(""));
      }
    }
  }

  RobotDescription read() {
    const xmlNode* root = nullptr;
    for (const xmlNode* element : elementsOf(robot_)) {
      if (nameOf(*element) == "swarmanoid") {
        if (root != nullptr) {
          fail(*element, "found a second <swarmanoid>, allowed: one");
        }
        root = element;
      }
    }
    if (root == nullptr) {
      throw ConfigError({file_}, "found no <swarmanoid> in <robot>, allowed: one, which says what the robot can do");
    }
    allowAttributes(*root, {"title", "summary"});
    result_.title = require(*root, "title");
    if (std::any_of(result_.title.begin(), result_.title.end(), [](unsigned char c) { return std::isspace(c) != 0; })) {
      fail(*root, "title: found '" + result_.title + "', allowed: one word");
    }
    result_.summary = require(*root, "summary");
    for (const xmlNode* element : elementsOf(*root)) {
      readElement(*element);
    }
    if (result_.battery) {
      result_.battery->devices = std::move(consumption_);
    } else if (!consumption_.empty()) {
      fail(*root, "found <consumption> and no <battery> in <swarmanoid>, allowed: both");
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const xmlNode& element, const std::string& message) const {
    throw ConfigError({file_, lineOf(&element)}, message);
  }

  void allowAttributes(const xmlNode& element, const std::vector<std::string>& names) const {
    for (const xmlAttr* attribute = element.properties; attribute != nullptr; attribute = attribute->next) {
      const std::string name = characters(attribute->name);
      if (!contains(names, name)) {
        fail(element, unknownName("attribute", name, names) + " (in <" + nameOf(element) + ">)");
      }
    }
  }

  std::string require(const xmlNode& element, const char* attribute) const {
    std::string value = attributeOf(element, attribute).value_or("");
    if (value.empty()) {
      fail(element, "<" + nameOf(element) + "> needs the attribute " + attribute + "=\"...\"");
    }
    return value;
  }

  /// @param known names in the URDF
  std::string requireKnown(const xmlNode& element, const char* attribute, const std::string& what,
                           const std::vector<std::string>& known) const {
    std::string value = require(element, attribute);
    if (!contains(known, value)) {
      fail(element, unknownName("the " + what, value, known) + " (in <" + nameOf(element) + ">)");
    }
    return value;
  }

  double requireNumber(const xmlNode& element, const char* attribute, Range range) const {
    return parseNumber(require(element, attribute), attribute, {file_, lineOf(&element)}, range);
  }

  void refuseSecond(const xmlNode& element, bool is_second) const {
    if (is_second) {
      fail(element, "found a second <" + nameOf(element) + "> in <swarmanoid>, allowed: one");
    }
  }

  void readElement(const xmlNode& element) {
    const std::string name = nameOf(element);
    if (name == "wheels") {
      refuseSecond(element, result_.wheels.has_value());
      allowAttributes(element, {"left", "right"});
      result_.wheels = RobotDescription::Wheels{requireKnown(element, "left", "joint", joints_),
                                                requireKnown(element, "right", "joint", joints_)};
    } else if (name == "gripper") {
      const auto is_gripper = [](const EntityModel::Holder& holder) { return holder.kind == Kind::kGripper; };
      refuseSecond(element, std::any_of(result_.holders.begin(), result_.holders.end(), is_gripper));
      readHolder(element, Kind::kGripper);
    } else if (name == "suction") {
      readHolder(element, Kind::kSuction);
    } else if (name == "magnet") {
      readHolder(element, Kind::kMagnet);
    } else if (name == "rope") {
      readHolder(element, Kind::kRope);
    } else if (name == "gripping_strip") {
      refuseSecond(element, !result_.gripping_strip.empty());
      allowAttributes(element, {"link"});
      result_.gripping_strip = requireKnown(element, "link", "link", links_);
    } else if (name == "leds") {
      refuseSecond(element, !result_.leds.empty());
      allowAttributes(element, {"links"});
      result_.leds = require(element, "links");
    } else if (name == "device") {
      readDevice(element);
    } else if (name == "battery") {
      refuseSecond(element, result_.battery.has_value());
      readBattery(element);
    } else if (name == "consumption") {
      allowAttributes(element, {"device", "power"});
      const std::string device = require(element, "device");
      if (!consumption_.emplace(device, requireNumber(element, "power", kPowerRange)).second) {
        fail(element, "found a second <consumption> of the device '" + device + "', allowed: one");
      }
    } else {
      const std::vector<std::string> known{"wheels",         "gripper", "suction", "magnet",  "rope",
                                           "gripping_strip", "leds",    "device",  "battery", "consumption"};
      fail(element, unknownName("tag", name, known) + " (in <swarmanoid>)");
    }
  }

  void readHolder(const xmlNode& element, Kind kind) {
    const bool is_rope = kind == Kind::kRope;
    allowAttributes(element, is_rope ? std::vector<std::string>{"name", "link", "length"}
                                     : std::vector<std::string>{"name", "link"});
    EntityModel::Holder holder;
    holder.name = require(element, "name");
    holder.kind = kind;
    holder.mount = requireKnown(element, "link", "link", links_);
    if (is_rope) {
      holder.rope_length = requireNumber(element, "length", limits::kLength);
    }
    const auto has_name = [&](const EntityModel::Holder& other) { return other.name == holder.name; };
    if (std::any_of(result_.holders.begin(), result_.holders.end(), has_name)) {
      fail(element, "found a second holder of the name '" + holder.name + "', allowed: one");
    }
    result_.holders.push_back(holder);
  }

  void readBattery(const xmlNode& element) {
    allowAttributes(element, {"capacity", "voltage", "electronics", "capacitor", "drive", "led", "rotors",
                              "rotor_radius", "rotor_efficiency"});
    const auto optional = [&](const char* attribute, Range range) {
      return attributeOf(element, attribute) ? requireNumber(element, attribute, range) : 0.0;
    };
    BatteryModel battery;
    battery.capacity = requireNumber(element, "capacity", kCapacityRange);
    battery.voltage = requireNumber(element, "voltage", {0.1, 1000.0});
    battery.electronics = requireNumber(element, "electronics", kPowerRange);
    battery.capacitor = optional("capacitor", kChargeRange);
    battery.drive = optional("drive", kPowerRange);
    battery.led = optional("led", kPowerRange);
    result_.battery = battery;
    if (attributeOf(element, "rotors") || attributeOf(element, "rotor_radius") ||
        attributeOf(element, "rotor_efficiency")) {
      const double radius = requireNumber(element, "rotor_radius", limits::kLength);
      result_.rotors = RobotDescription::Rotors{M_PI * radius * radius * rotorsOf(element),
                                                requireNumber(element, "rotor_efficiency", {0.01, 1.0})};
    }
  }

  double rotorsOf(const xmlNode& element) const {
    return static_cast<double>(
        parseInteger(require(element, "rotors"), "rotors", {file_, lineOf(&element)}, {1.0, 100.0}));
  }

  void readDevice(const xmlNode& element) {
    allowAttributes(element, {"type"});
    const std::string type = require(element, "type");
    if (contains(result_.devices, type)) {
      fail(element, "found a second device '" + type + "', allowed: one");
    }
    result_.devices.push_back(type);
  }

  const xmlNode& robot_;
  const std::string& file_;
  std::vector<std::string> links_;
  std::vector<std::string> joints_;
  RobotDescription result_;
  std::map<std::string, double, std::less<>> consumption_;
};

}  // namespace

RobotDescription readRobotDescription(const xmlDoc& document, const std::string& file) {
  return Reader(document, file).read();
}

}  // namespace swarmanoid
