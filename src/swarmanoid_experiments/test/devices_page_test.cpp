// docs/reference/devices.md says of each device what headers, registry, engines and topics say, and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {
namespace {

using Texts = std::vector<std::string>;

constexpr const char* kAnyRobot = "any robot";

std::string read(const std::string& name) {
  std::ifstream file(std::string(REPOSITORY) + name);
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Group 1 of every match; of all groups, with spaces between, if there are more.
Texts allOf(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  Texts found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex); match != std::sregex_iterator(); ++match) {
    std::string one = (*match)[1].str();
    for (std::size_t i = 2; i < match->size(); ++i) {
      one += " " + (*match)[i].str();
    }
    found.push_back(one);
  }
  return found;
}

/// What the page says of one device.
struct Section {
  std::string robot;
  std::string text;

  Texts fields() const { return allOf(text, R"(\n\| `([\w.\[\]]+)` \| `([\w\[\]]+)` \|)"); }
  /// Of the fields that have one; other third columns begin with a range, or say what the numbers mean.
  Texts units() const {
    return allOf(text, R"(\n\| `[\w.\[\]]+` \| `[\w\[\]]+` \| (rad/s|rad|m/s|m|N m|N)(?:, [^|]*)? \|)");
  }
  Texts parameters() const { return allOf(text, R"(\n\| `(\w+)` \| ([^|`]+) \| ([^|]*?) ?\| ([^|]*?) ?\|)"); }
  std::string line(const std::string& start) const {
    const Texts found = allOf(text, ("\n" + start + ": (.*)").c_str());
    return found.size() == 1 ? found[0] : "not there once: " + start;
  }
};

std::map<std::string, Section> sections() {
  const std::string page = read("/docs/reference/devices.md");
  std::map<std::string, Section> result;
  std::string robot;
  Section* section = nullptr;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("## ", 0) == 0) {
      robot = line.substr(3);
      robot[0] = static_cast<char>(std::tolower(robot[0]));
      section = nullptr;
    } else if (line.rfind("### ", 0) == 0) {
      section = &result[line.substr(4)];
      EXPECT_TRUE(section->robot.empty()) << "twice: " << line;
      section->robot = robot;
    } else if (section != nullptr) {
      section->text += "\n" + line;
    }
  }
  return result;
}

std::vector<const Registry::Entry*> devices() {
  loadBuiltInPlugins();
  std::vector<const Registry::Entry*> entries = Registry::instance().all(PluginKind::kSensor);
  const auto actuators = Registry::instance().all(PluginKind::kActuator);
  entries.insert(entries.end(), actuators.begin(), actuators.end());
  return entries;
}

/// The fields of a device as the page has them: "value float32[24]", "joints[6].angle float64", "ring Color[12]".
Texts fieldsOf(const DeviceType& device) {
  Texts fields;
  for (const FieldDescription& field : device.fields) {
    std::string name = field.name;
    std::string type = typeName(field);
    if (const std::size_t channel = name.rfind(".red"); channel != std::string::npos) {
      name.erase(channel);
      type = "Color";
    } else if (name.rfind(".green") != std::string::npos || name.rfind(".blue") != std::string::npos) {
      continue;
    }
    const std::size_t bracket = name.find("[]");
    const std::string count = field.count == 0 ? "" : std::to_string(field.count);
    if (bracket != std::string::npos && bracket + 2 == name.size()) {
      name.erase(bracket);
      type += "[" + count + "]";
    } else if (bracket != std::string::npos) {
      name.insert(bracket + 1, count);
    }
    fields.push_back(name + " " + type);
  }
  return fields;
}

/// Their units, as the page's third column begins.
Texts unitsOf(const DeviceType& device) {
  Texts units;
  for (const FieldDescription& field : device.fields) {
    if (!field.unit.empty()) {
      units.push_back(field.unit);
    }
  }
  return units;
}

TEST(DevicesPageTest, HasASectionForEachDeviceAndNoOther) {
  std::map<std::string, Section> page = sections();
  for (const Registry::Entry* entry : devices()) {
    const PluginDescription& device = entry->description;
    ASSERT_EQ(page.count(device.label), 1U) << device.label;
    const Section& section = page[device.label];
    EXPECT_EQ(device.robots, section.robot == kAnyRobot ? Texts{} : Texts{section.robot}) << device.label;
    if (section.robot != kAnyRobot) {
      const Texts& listed = robotModel(section.robot)->devices;
      EXPECT_EQ(std::count(listed.begin(), listed.end(), device.label), 1) << device.label << " in the robot's URDF";
    }
    const bool is_sensor = entry->kind == PluginKind::kSensor;
    EXPECT_NE(section.text.find(is_sensor ? "\nSensor. " : "\nActuator. "), std::string::npos) << device.label;
    EXPECT_NE(section.line("Header").find("Implementation: `" + device.implementation + "`."), std::string::npos)
        << device.label;
    page.erase(device.label);
  }
  EXPECT_TRUE(page.empty()) << "no device: " << page.begin()->first;
}

TEST(DevicesPageTest, FieldsAndUnitsAreThoseOfTheDescriptors) {
  for (const auto& [type, section] : sections()) {
    const DeviceType* device = findDeviceType(type);
    ASSERT_NE(device, nullptr) << type;
    EXPECT_EQ(fieldsOf(*device), section.fields()) << type;
    EXPECT_EQ(unitsOf(*device), section.units()) << type;
    const bool is_sensor = section.text.find("\nSensor. ") != std::string::npos;
    EXPECT_EQ(is_sensor ? "sensor" : "actuator", std::string(toString(device->kind))) << type;
  }
}

TEST(DevicesPageTest, HeadersAreThoseOfTheDevices) {
  for (const auto& [type, section] : sections()) {
    const std::string line = section.line("Header");
    std::smatch found;
    ASSERT_TRUE(
        std::regex_match(line, found, std::regex(R"(\[`(\S+)`\]\(\.\./\.\.(/\S+/\1)\), `(\w+)`\. Implementation: .*)")))
        << type << ": " << line;
    const std::string text = read(found[2]);
    EXPECT_NE(text.find("kType = \"" + type + "\""), std::string::npos) << type;
    EXPECT_NE(text.find("REGISTER_DEVICE(" + found[3].str() + ","), std::string::npos) << type;
  }
}

TEST(DevicesPageTest, ParametersAreThoseOfTheRegistry) {
  std::map<std::string, Section> page = sections();
  for (const Registry::Entry* entry : devices()) {
    Texts expected;
    for (const Parameter& parameter : entry->description.parameters) {
      const bool is_number = parameter.type != Parameter::Type::kBoolean;
      expected.push_back(parameter.name + " " + parameter.value.value_or("required") + " " + parameter.unit + " " +
                         (is_number ? parameter.range.toString() : ""));
    }
    EXPECT_EQ(expected, page[entry->description.label].parameters()) << entry->description.label;
  }
}

TEST(DevicesPageTest, EnginesAreThoseThatTakeTheDevice) {
  std::map<std::string, Section> page = sections();
  for (const Registry::Entry* entry : devices()) {
    const std::string& type = entry->description.label;
    const std::string robot = page[type].robot == kAnyRobot ? "footbot" : page[type].robot;
    std::string expected;
    for (const char* label : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
      const auto engine = makePlugin<Engine>(Registry::instance().require(PluginKind::kEngine, label));
      if (engine->unsupportedReason(*robotModel(robot), {{type, entry->description.mechanisms}}).empty()) {
        expected += std::string(expected.empty() ? "`" : ", `") + label + "`";
      }
    }
    EXPECT_EQ(expected + ".", page[type].line("Engines")) << type;
  }
}

/// A table of docs/reference/drivers.md, which a test of its own holds against the code: device, topic and message.
TEST(DevicesPageTest, TopicsAreThoseOfDrivers) {
  std::map<std::string, std::string> expected;
  const std::string drivers = read("/docs/reference/drivers.md");
  for (const std::string& row : allOf(drivers, R"(\n\| (`\w+` \| `\S+` \| `\S+/\S+`) \|)")) {
    std::smatch found;
    ASSERT_TRUE(std::regex_match(row, found, std::regex(R"(`(\w+)` \| (`\S+`) \| (`\S+`))")));
    std::string& topics = expected[found[1]];
    topics += (topics.empty() ? "" : ", ") + found[2].str() + " (" + found[3].str() + ")";
  }
  for (const auto& [type, section] : sections()) {
    EXPECT_EQ(expected[type] + ".", section.line("Topics")) << type;
  }
}

}  // namespace
}  // namespace swarmanoid
