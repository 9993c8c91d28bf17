/// The widgets of the panel and where they stand; what they do is in run_panel.cpp. Tests find them by their object
/// names.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

#include "device_tree.hpp"

namespace swarmanoid {

struct RunPanelWidgets {
  /// Makes them children of the panel, which owns them.
  explicit RunPanelWidgets(QWidget& panel);

  QToolButton* play;  ///< resumes or pauses
  QToolButton* step;  ///< so many ticks
  QSpinBox* ticks;
  QToolButton* reset;
  QLineEdit* seed;  ///< of the next reset; empty: as it is
  QComboBox* pace;  ///< real-time factors; the data of each is the number
  QLabel* run;      ///< state, tick, time, speed that is reached
  QLineEdit* name;  ///< of the selected entity
  QLabel* entity;
  DeviceTree* devices;
  QLabel* answer;  ///< of the space to what was last asked for
};

/// "2 x", "as fast as possible"
QString paceText(double real_time_factor);

/// Chooses that factor, which is added if it is none of those offered. No signal is sent.
void choosePace(QComboBox& pace, double real_time_factor);

}  // namespace swarmanoid
