#include "device_tree.hpp"

#include <QHeaderView>

namespace swarmanoid {
namespace {

enum Column { kName, kValue, kUnit };

/// Sets a text only if it differs: a repaint costs more than the comparison.
void setText(QTreeWidgetItem& item, Column column, const QString& text) {
  if (item.text(column) != text) {
    item.setText(column, text);
  }
}

QString valueText(double value) { return QString::number(value, 'g', 4); }

/// The first numbers in one line; the column clips the rest.
QString lineOf(const std::vector<double>& values) {
  constexpr std::size_t kMost = 32;
  QStringList texts;
  for (std::size_t i = 0; i < values.size() && i < kMost; ++i) {
    texts << valueText(values[i]);
  }
  return texts.join("  ");
}

void fit(QTreeWidgetItem& item, std::size_t count) {
  while (static_cast<std::size_t>(item.childCount()) > count) {
    delete item.takeChild(item.childCount() - 1);
  }
  while (static_cast<std::size_t>(item.childCount()) < count) {
    item.addChild(new QTreeWidgetItem);
  }
}

}  // namespace

DeviceTree::DeviceTree(QWidget* parent) : QTreeWidget(parent) {
  setHeaderLabels({"device", "value", "unit"});
  setUniformRowHeights(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(kName, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kValue, QHeaderView::Stretch);
  header()->setSectionResizeMode(kUnit, QHeaderView::ResizeToContents);
  connect(this, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) { noteOpen(*item); });
  connect(this, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* item) { noteOpen(*item); });
}

void DeviceTree::noteOpen(const QTreeWidgetItem& item) {
  if (item.isExpanded()) {
    open_.insert(item.text(kName));
  } else {
    open_.erase(item.text(kName));
  }
}

QTreeWidgetItem* DeviceTree::rowOf(std::size_t device, const swarmanoid_msgs::DeviceStatus& status) {
  const QString type = QString::fromStdString(status.type);
  const int place = static_cast<int>(device);
  while (place < topLevelItemCount() && topLevelItem(place)->text(kName) != type) {
    delete takeTopLevelItem(place);  // a row of another robot
  }
  if (place == topLevelItemCount()) {
    auto* item = new QTreeWidgetItem(this);
    item->setText(kName, type);
    item->setToolTip(kName, status.is_actuator != 0 ? "actuator: what its controller commands" : "sensor");
    item->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
    item->setExpanded(open_.count(type) > 0);
  }
  return topLevelItem(place);
}

void DeviceTree::showDevices(const std::vector<swarmanoid_msgs::DeviceStatus>& devices) {
  for (std::size_t device = 0; device < devices.size(); ++device) {
    const swarmanoid_msgs::DeviceStatus& status = devices[device];
    QTreeWidgetItem* item = rowOf(device, status);
    setText(*item, kValue, lineOf(status.values));
    fit(*item, status.names.size());
    for (std::size_t i = 0; i < status.names.size(); ++i) {
      QTreeWidgetItem& row = *item->child(static_cast<int>(i));
      setText(row, kName, QString::fromStdString(status.names[i]));
      setText(row, kValue, valueText(status.values[i]));
      setText(row, kUnit, QString::fromStdString(status.units[i]));
    }
  }
  while (static_cast<std::size_t>(topLevelItemCount()) > devices.size()) {
    delete takeTopLevelItem(topLevelItemCount() - 1);
  }
}

}  // namespace swarmanoid
