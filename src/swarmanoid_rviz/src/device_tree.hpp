/// Tree of the device readings of one robot: a row per device, and below it a row per number.
#pragma once

#include <swarmanoid_msgs/DeviceStatus.h>

#include <QTreeWidget>
#include <set>
#include <vector>

namespace swarmanoid {

class DeviceTree : public QTreeWidget {
 public:
  explicit DeviceTree(QWidget* parent = nullptr);

  /// Expanded rows stay expanded, also for other robots with the same type of device.
  void showDevices(const std::vector<swarmanoid_msgs::DeviceStatus>& devices);

 private:
  void noteOpen(const QTreeWidgetItem& item);
  QTreeWidgetItem* rowOf(std::size_t device, const swarmanoid_msgs::DeviceStatus& status);

  std::set<QString> open_;  // device types of expanded rows
};

}  // namespace swarmanoid
