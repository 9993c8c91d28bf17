// docs/reference/drivers.md has the same content as the table of device topics.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {
namespace {

/// Returns device, topic, type, and the frame of readings, for each row of a section's table.
std::set<std::string> rowsOf(const std::string& section, bool has_frame) {
  std::ifstream page(PAGE);
  EXPECT_TRUE(page) << PAGE;
  const std::regex row(has_frame ? R"(\| `(\S+)` \| `(\S+)` \| `(\S+)` \| `(\S+)` \|.*)"
                                 : R"(\| `(\S+)` \| `(\S+)` \| `(\S+)` \|.*)");
  std::set<std::string> rows;
  bool is_in_section = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("## ", 0) == 0) {
      is_in_section = line == "## " + section;
    }
    std::smatch found;
    if (is_in_section && std::regex_match(line, found, row)) {
      std::string text;
      for (std::size_t i = 1; i < found.size(); ++i) {
        text += found[i].str() + " ";
      }
      EXPECT_TRUE(rows.insert(text).second) << "twice: " << line;
    }
  }
  return rows;
}

std::set<std::string> topicsOfKind(DeviceTopic::Kind kind) {
  std::set<std::string> rows;
  for (const DeviceTopic* topic : deviceTopics()) {
    if (topic->kind == kind) {
      rows.insert(topic->device + " " + topic->name + " " + topic->message + " " +
                  (topic->frame.empty() ? "" : topic->frame + " "));
    }
  }
  return rows;
}

TEST(DriversPage, NamesWhatIsPublished) {
  EXPECT_EQ(topicsOfKind(DeviceTopic::Kind::kReading), rowsOf("Published", true));
}

TEST(DriversPage, NamesWhatIsSubscribed) {
  EXPECT_EQ(topicsOfKind(DeviceTopic::Kind::kCommand), rowsOf("Subscribed", false));
}

/// The last column of a device's row: "zero", "as it is", ...
std::string safeStopOf(const std::string& device) {
  std::ifstream page(PAGE);
  const std::regex row(R"(\| `)" + device + R"(` \|.*\| ([^|]*) \|)");
  for (std::string line; std::getline(page, line);) {
    std::smatch found;
    if (std::regex_match(line, found, row)) {
      return found[1];
    }
  }
  return "no row";
}

TEST(DriversPage, SaysWhichActuatorsJustRest) {
  for (const DeviceTopic* topic : deviceTopics()) {
    const DeviceType& type = *findDeviceType(topic->device);
    EXPECT_EQ(topic->kind == DeviceTopic::Kind::kCommand, type.kind == DeviceKind::kActuator) << topic->device;
    if (type.kind == DeviceKind::kActuator) {
      EXPECT_EQ(type.has_own_stop, safeStopOf(topic->device) != "zero") << topic->device;
    }
  }
}

}  // namespace
}  // namespace swarmanoid
