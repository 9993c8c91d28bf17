#include "run_panel_widgets.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStyle>
#include <QVBoxLayout>
#include <initializer_list>

namespace swarmanoid {
namespace {

template <class Widget>
Widget* make(QWidget& panel, const char* name, const QString& tip) {
  auto* widget = new Widget(&panel);
  widget->setObjectName(name);
  widget->setToolTip(tip);
  return widget;
}

QToolButton* makeButton(QWidget& panel, const char* name, QStyle::StandardPixmap icon, const QString& tip) {
  auto* button = make<QToolButton>(panel, name, tip);
  button->setIcon(panel.style()->standardIcon(icon));
  return button;
}

QLabel* makeText(QWidget& panel, const char* name) {
  auto* label = make<QLabel>(panel, name, "");
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setTextFormat(Qt::PlainText);
  return label;
}

}  // namespace

RunPanelWidgets::RunPanelWidgets(QWidget& panel)
    : play(makeButton(panel, "play", QStyle::SP_MediaPlay, "resume")),
      step(makeButton(panel, "step", QStyle::SP_MediaSkipForward, "so many ticks, as fast as possible")),
      ticks(make<QSpinBox>(panel, "ticks", "of a step")),
      reset(makeButton(panel, "reset", QStyle::SP_BrowserReload, "back to before the first tick")),
      seed(make<QLineEdit>(panel, "seed", "of the next reset; empty: as it is")),
      pace(make<QComboBox>(panel, "pace", "simulated seconds for each real one")),
      run(makeText(panel, "run")),
      name(make<QLineEdit>(panel, "name", "of an entity; or click on one with the tool Move")),
      entity(makeText(panel, "entity")),
      devices(make<DeviceTree>(panel, "devices", "")),
      answer(makeText(panel, "answer")) {
  ticks->setRange(1, 1'000'000);
  ticks->setPrefix("ticks: ");
  seed->setPlaceholderText("seed");
  name->setPlaceholderText("entity");
  for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 50.0, 0.0}) {
    pace->addItem(paceText(factor), factor);
  }
  auto* buttons = new QHBoxLayout;
  for (QWidget* widget : std::initializer_list<QWidget*>{play, step, ticks, reset, seed}) {
    buttons->addWidget(widget);
  }
  auto* layout = new QVBoxLayout(&panel);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(buttons);
  for (QWidget* widget : std::initializer_list<QWidget*>{pace, run, name, entity, devices, answer}) {
    layout->addWidget(widget);
  }
  layout->setStretchFactor(devices, 1);
}

QString paceText(double real_time_factor) {
  return real_time_factor == 0.0 ? QString("as fast as possible") : QString::number(real_time_factor) + " x real time";
}

void choosePace(QComboBox& pace, double real_time_factor) {
  const QSignalBlocker blocked(pace);
  int place = pace.findData(real_time_factor);
  if (place < 0) {
    pace.addItem(paceText(real_time_factor), real_time_factor);
    place = pace.count() - 1;
  }
  pace.setCurrentIndex(place);
}

}  // namespace swarmanoid
