/// What the devices of one robot say, as a tree: a row each, and below it a row for each of its numbers.
#pragma once

#include <swarmanoid_msgs/DeviceStatus.h>

#include <QTreeWidget>
#include <vector>

namespace swarmanoid {

class DeviceTree : public QTreeWidget {
 public:
  explicit DeviceTree(QWidget* parent = nullptr);

  /// Rows that were open stay open, also for another robot that has such a device.
  void showDevices(const std::vector<swarmanoid_msgs::DeviceStatus>& devices);

 private:
  QTreeWidgetItem* rowOf(std::size_t device, const swarmanoid_msgs::DeviceStatus& status);
};

}  // namespace swarmanoid
