// The sections Topics of devices in docs/reference/devices/ have the same content as the table of device topics.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {
namespace {

using Rows = std::vector<std::string>;

/// Adds the rows of the sections Topics of a page, without their headings, by device.
void addRowsOf(const std::filesystem::path& page, std::map<std::string, Rows>& rows) {
  static const std::string device_heading = "## ";
  std::ifstream file(page);
  EXPECT_TRUE(file) << page;
  std::string device;
  bool is_in_section = false;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(device_heading, 0) == 0) {
      device = line.substr(device_heading.size());
      is_in_section = false;
    } else if (line.rfind("### ", 0) == 0) {
      is_in_section = line == "### Topics";
    } else if (is_in_section && line.rfind("| `", 0) == 0) {
      rows[device].push_back(line);
    }
  }
}

/// Returns the rows of all devices that have some, by device.
std::map<std::string, Rows> tables() {
  std::map<std::string, Rows> result;
  for (const auto& page : std::filesystem::directory_iterator(PAGES)) {
    addRowsOf(page.path(), result);
  }
  return result;
}

/// Returns topic, type, and the frame of readings.
std::string contentOf(const std::string& row) {
  static const std::regex columns(R"(\| `(\S+)` \| `(\S+)` \| (?:`(\S+)` \| )?.*)");
  std::smatch found;
  return std::regex_match(row, found, columns) ? found[1].str() + " " + found[2].str() + " " + found[3].str() : row;
}

TEST(TopicTables, NameTopicTypeAndFrameOfEachDevice) {
  std::map<std::string, Rows> expected;
  for (const DeviceTopic* topic : deviceTopics()) {
    expected[topic->device].push_back(topic->name + " " + topic->message + " " + topic->frame);
  }
  std::map<std::string, Rows> found;
  for (const auto& [device, rows] : tables()) {
    for (const std::string& row : rows) {
      found[device].push_back(contentOf(row));
    }
  }
  for (const auto& [device, topics] : expected) {
    EXPECT_EQ(topics, found[device]) << PAGES << ", topics of " << device << ", the main topic first";
    found.erase(device);
  }
  EXPECT_TRUE(found.empty()) << "no topics, or no device: " << found.begin()->first;
}

/// Returns the last column of a row: "zero", "as it is", ...
std::string safeStopIn(const std::string& row) {
  static const std::regex last(R"(.*\| ([^|]*) \|)");
  std::smatch found;
  return std::regex_match(row, found, last) ? found[1].str() : row;
}

TEST(TopicTables, SayWhichActuatorsJustRest) {
  for (const auto& [device, rows] : tables()) {
    const DeviceType* type = findDeviceType(device);
    ASSERT_NE(type, nullptr) << device;
    for (const DeviceTopic* topic : topicsOf(device)) {
      EXPECT_EQ(topic->kind == DeviceTopic::Kind::kCommand, type->kind == DeviceKind::kActuator) << device;
    }
    for (const std::string& row : rows) {
      if (type->kind == DeviceKind::kActuator) {
        EXPECT_EQ(type->has_own_stop, safeStopIn(row) != "zero") << device << ": " << row;
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid
