/// The widgets of the panel and their layout; run_panel.cpp connects them. Tests find them by their object names.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

#include "device_tree.hpp"

namespace swarmanoid {

struct RunPanelWidgets {
  /// Creates the widgets as children of the panel, which owns them.
  explicit RunPanelWidgets(QWidget& panel);

  QToolButton* play;  ///< resumes or pauses
  QToolButton* step;  ///< runs `ticks` ticks
  QSpinBox* ticks;
  QToolButton* reset;
  QLineEdit* seed;  ///< for the next reset; empty: unchanged
  QComboBox* pace;  ///< real-time factors; the data of each item is the number
  QLabel* run;      ///< state, tick, time, achieved speed
  QLineEdit* name;  ///< of the selected entity
  QLabel* entity;
  DeviceTree* devices;
  QLabel* answer;  ///< answer of the space to the last request
};

/// "2 x", "as fast as possible"
QString paceText(double real_time_factor);

/// Selects that factor, and adds it to the list if it is missing. Emits no signal.
void choosePace(QComboBox& pace, double real_time_factor);

}  // namespace swarmanoid
