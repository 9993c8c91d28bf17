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

/// The data members of a header's structs, as the page writes them: "left.shoulder float64".
class Header {
 public:
  explicit Header(std::string text) : text_(std::move(text)) {}

  Texts fieldsOf(const std::string& name) const {
    std::smatch found;
    const std::regex start("struct " + name + R"((?: : (\w+))? \{)");
    if (!std::regex_search(text_, found, start)) {
      return {"no struct " + name};
    }
    Texts fields = found[1].matched ? fieldsOf(found[1]) : Texts{};
    // members of the struct itself: those of nested ones and of functions are deeper
    // members of the struct itself: those of nested ones and of functions are deeper
    const std::regex member(R"( +(?!return |using |static )([\w:]+(?:<.*>)?) (\w+)(?: = [^;]+|\{\})?;.*)");
    std::istringstream body(found.suffix().str());
    int depth = 1;
    for (std::string line; depth > 0 && std::getline(body, line);) {
      const int before = depth;
      depth += static_cast<int>(std::count(line.begin(), line.end(), '{') - std::count(line.begin(), line.end(), '}'));
      std::smatch found_member;
      if (before == 1 && depth == 1 && std::regex_match(line, found_member, member)) {
        const Texts typed = withType(found_member[2], found_member[1], name);
        fields.insert(fields.end(), typed.begin(), typed.end());
      }
    }
    return fields;
  }

 private:
  Texts withType(const std::string& field, const std::string& type, const std::string& owner) const {
    static const std::map<std::string, std::string> kPlain{{"double", "float64"}, {"float", "float32"},
                                                           {"bool", "bool"},      {"Mode", "uint8"},
                                                           {"Color", "Color"},    {"Eigen::Vector3d", "float64[3]"}};
    if (const auto plain = kPlain.find(type); plain != kPlain.end()) {
      return {field + " " + plain->second};
    }
    std::smatch found;
    if (std::regex_match(type, found, std::regex(R"(Span<const (\w+)>)"))) {
      return elements(field, found[1], "");
    }
    if (std::regex_match(type, found, std::regex(R"(std::array<(\w+), (\w+)>)"))) {
      return elements(field, found[1], constant(found[2], owner));
    }
    return nested(field, type);
  }

  Texts elements(const std::string& field, const std::string& type, const std::string& count) const {
    const Texts one = withType("", type, "");
    if (one.size() == 1) {
      return {field + one[0] + "[" + count + "]"};
    }
    return nested(field + "[" + count + "]", type);
  }

  Texts nested(const std::string& field, const std::string& type) const {
    Texts fields;
    for (const std::string& inner : fieldsOf(type)) {
      fields.push_back(field + "." + inner);
    }
    return fields;
  }

  /// The value of a constant of a struct.
  std::string constant(const std::string& name, const std::string& owner) const {
    const std::string from = text_.substr(text_.find("struct " + owner + " "));
    std::smatch found;
    return std::regex_search(from, found, std::regex(name + " = (\\d+);")) ? found[1].str() : "?";
  }

  std::string text_;
};

/// The layout (device_type.hpp) of fields as the page has them.
std::string layoutOf(const Texts& fields) {
  static const std::map<std::string, std::string> kLayouts{
      {"bool", "b1"}, {"uint8", "u1"}, {"float32", "f4"}, {"float64", "f8"}, {"Color", "u1 u1 u1"}};
  const auto repeat = [](const std::string& layout, const std::string& count) {
    std::string result = layout;
    for (int i = 1; i < std::stoi(count); ++i) {
      result += " " + layout;
    }
    return result;
  };
  std::string layout;
  for (std::size_t i = 0; i < fields.size();) {
    std::smatch found;
    std::string group;
    std::string count = "1";
    // members of repeated structs follow each other
    const std::regex row(R"((\w+)(\[\d*\])?(?:\.\w+)? (\w+)(?:\[(\d+)\])?)");
    const std::string first = fields[i];
    const std::string prefix = first.substr(0, first.find('.') + 1);
    const bool is_repeated = prefix.find('[') != std::string::npos;
    do {
      EXPECT_TRUE(std::regex_match(fields[i], found, row)) << fields[i];
      const std::string one = repeat(kLayouts.at(found[3]), found[4].matched ? found[4].str() : "1");
      group += (group.empty() ? "" : " ") + one;
      ++i;
    } while (is_repeated && i < fields.size() && fields[i].rfind(prefix, 0) == 0);
    if (is_repeated) {
      count = prefix.substr(prefix.find('[') + 1, prefix.find(']') - prefix.find('[') - 1);
    }
    layout += layout.empty() ? "" : " ";
    layout += count.empty() ? "(" + group + ")*" : repeat(group, count);
  }
  return layout;
}

TEST(DevicesPageTest, HasASectionForEachDeviceAndNoOther) {
  std::map<std::string, Section> page = sections();
  for (const Registry::Entry* entry : devices()) {
    const PluginDescription& device = entry->description;
    ASSERT_EQ(page.count(device.label), 1U) << device.label;
    const Section& section = page[device.label];
    EXPECT_EQ(device.robots, Texts{section.robot}) << device.label;
    const bool is_sensor = entry->kind == PluginKind::kSensor;
    EXPECT_NE(section.text.find(is_sensor ? "\nSensor. " : "\nActuator. "), std::string::npos) << device.label;
    EXPECT_NE(section.line("Header").find("Implementation: `" + device.implementation + "`."), std::string::npos)
        << device.label;
    page.erase(device.label);
  }
  EXPECT_TRUE(page.empty()) << "no device: " << page.begin()->first;
}

TEST(DevicesPageTest, FieldsAreThoseOfTheHeaders) {
  for (const auto& [type, section] : sections()) {
    const std::string line = section.line("Header");
    std::smatch found;
    ASSERT_TRUE(
        std::regex_match(line, found, std::regex(R"(\[`(\S+)`\]\(\.\./\.\.(/\S+/\1)\), `(\w+)`\. Implementation: .*)")))
        << type << ": " << line;
    const std::string text = read(found[2]);
    EXPECT_NE(text.find("kType = \"" + type + "\""), std::string::npos) << type;
    EXPECT_EQ(Header(text).fieldsOf(found[3]), section.fields()) << type;
    const DeviceType* device = findDeviceType(type);
    ASSERT_NE(device, nullptr) << type;
    EXPECT_EQ(device->layout, layoutOf(section.fields())) << type;
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
    std::string expected;
    for (const char* label : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
      const auto engine = makePlugin<Engine>(Registry::instance().require(PluginKind::kEngine, label));
      if (engine->unsupportedReason(*robotModel(page[type].robot), {type}).empty()) {
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
