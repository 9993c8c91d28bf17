/// What the devices of one robot say, as a tree: a row each, and below it a row for each of its numbers.
#pragma once

#include <swarmanoid_msgs/DeviceStatus.h>

#include <QTreeWidget>
#include <set>
#include <vector>

namespace swarmanoid {

class DeviceTree : public QTreeWidget {
 public:
  explicit DeviceTree(QWidget* parent = nullptr);

  /// Rows that were opened stay open, also of other robots that have such a device.
  void showDevices(const std::vector<swarmanoid_msgs::DeviceStatus>& devices);

 private:
  void noteOpen(const QTreeWidgetItem& item);
  QTreeWidgetItem* rowOf(std::size_t device, const swarmanoid_msgs::DeviceStatus& status);

  std::set<QString> open_;  // types of devices
};

}  // namespace swarmanoid
