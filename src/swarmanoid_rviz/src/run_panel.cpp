#include "run_panel.hpp"

#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <rviz/window_manager_interface.h>
#include <std_srvs/Trigger.h>
#include <swarmanoid_msgs/Reset.h>
#include <swarmanoid_msgs/SetRealTimeFactor.h>
#include <swarmanoid_msgs/Step.h>
#include <pluginlib/class_list_macros.hpp>

#include <QAbstractItemView>
#include <QStyle>
#include <cmath>

#include "camera_places.hpp"
#include "heading.hpp"

namespace swarmanoid {
namespace {

using swarmanoid_msgs::Inspect;

constexpr int kInterval = 200;  // [ms]

QString text(const std::string& words) { return QString::fromStdString(words); }

QString describe(const Inspect::Response& state) {
  QStringList lines;
  lines << text(state.type) + (state.engine.empty() ? ", moved by no engine" : ", moved by " + text(state.engine));
  if (!state.controller.empty()) {
    lines << "controller " + text(state.controller) + ", commanded by " + text(state.command_source);
  }
  const auto& position = state.pose.position;
  lines << QString("at %1, %2, %3 m, heading %4°")
               .arg(position.x, 0, 'f', 3)
               .arg(position.y, 0, 'f', 3)
               .arg(position.z, 0, 'f', 3)
               .arg(headingOf(state.pose.orientation) * 180.0 / M_PI, 0, 'f', 1);
  const auto& linear = state.twist.linear;
  lines << QString("%1 m/s, turns at %2 rad/s")
               .arg(std::hypot(linear.x, linear.y, linear.z), 0, 'f', 3)
               .arg(state.twist.angular.z, 0, 'f', 3);
  if (!state.gripped.empty()) {
    lines << "grips " + text(state.gripped);
  }
  if (!state.failure.empty()) {
    lines << "failed: " + text(state.failure);
  }
  return lines.join("\n");
}

}  // namespace

RunPanel::RunPanel(QWidget* parent)
    : rviz::Panel(parent), widgets_(*this), selection_([this] {
        widgets_.name->setText(text(selection_.name()));
        poll();
      }) {
  connectWidgets();
  timer_.start(kInterval);
  since_start_.start();
}

RunPanel::~RunPanel() {
  for (const QPointer<QShortcut>& shortcut : shortcuts_) {
    delete shortcut;
  }
}

void RunPanel::addShortcut(QWidget* window, int key, const std::function<void()>& act) {
  shortcuts_.push_back(new QShortcut(QKeySequence(key), window));
  connect(shortcuts_.back(), &QShortcut::activated, this, act);
}

void RunPanel::onInitialize() {
  QWidget* window = vis_manager_->getWindowManager()->getParentWindow();  // the panel itself may be hidden
  for (int number = 0; number < kCameraPlaces; ++number) {
    addShortcut(window, Qt::CTRL + Qt::Key_0 + number, [this, number] {
      const std::string digit = std::to_string(number);
      const bool is_there = recallCamera(*vis_manager_->getViewManager(), number);
      say(is_there ? "camera " + digit
                   : "there is no camera " + digit + "; Ctrl+Alt+" + digit + " keeps this view as it",
          !is_there);
    });
    addShortcut(window, Qt::CTRL + Qt::ALT + Qt::Key_0 + number, [this, number] {
      keepCamera(*vis_manager_->getViewManager(), number);
      say("this view is kept as camera " + std::to_string(number), false);
    });
  }
}

void RunPanel::connectWidgets() {
  connect(&timer_, &QTimer::timeout, this, &RunPanel::poll);
  connect(widgets_.play, &QToolButton::clicked, this, &RunPanel::resumeOrPause);
  connect(widgets_.reset, &QToolButton::clicked, this, &RunPanel::reset);
  connect(widgets_.step, &QToolButton::clicked, this, [this] {
    swarmanoid_msgs::Step::Request request;
    request.ticks = static_cast<std::uint32_t>(widgets_.ticks->value());
    ask<swarmanoid_msgs::Step>("step", request);
  });
  connect(widgets_.pace, QOverload<int>::of(&QComboBox::activated), this, [this](int place) {
    swarmanoid_msgs::SetRealTimeFactor::Request request;
    request.real_time_factor = widgets_.pace->itemData(place).toDouble();
    ask<swarmanoid_msgs::SetRealTimeFactor>("set_real_time_factor", request);
  });
  connect(widgets_.name, &QLineEdit::editingFinished, this,
          [this] { selection_.choose(widgets_.name->text().trimmed().toStdString()); });
}

void RunPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString space;
  if (config.mapGetString("Space", &space)) {
    requests_.setSpace(space.toStdString());
  }
}

void RunPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Space", text(requests_.space()));
}

template <class Service>
void RunPanel::ask(const std::string& service, const typename Service::Request& request) {
  say(service + " ...", false);
  const std::uint64_t number = ++requests_made_;
  requests_.call<Service>(service, request, [this, number](const typename Service::Response& response) {
    if (number == requests_made_) {
      say(response.message, response.success == 0);
    }
    speed_.restart();
    poll();
  });
}

void RunPanel::resumeOrPause() { ask<std_srvs::Trigger>(is_going_ ? "pause" : "resume", {}); }

void RunPanel::reset() {
  const QString seed = widgets_.seed->text().trimmed();
  swarmanoid_msgs::Reset::Request request;
  bool is_number = true;
  request.seed = seed.isEmpty() ? 0 : seed.toULongLong(&is_number);
  if (!is_number) {
    say("seed: found '" + seed.toStdString() + "', allowed: a whole number from 0", true);
    return;
  }
  request.zero_seed = !seed.isEmpty() && request.seed == 0 ? 1 : 0;
  ask<swarmanoid_msgs::Reset>("reset", request);
}

void RunPanel::poll() {
  if (!isVisible()) {
    return;
  }
  if (since_poll_.isValid()) {
    constexpr qint64 kLate = 2000;  // [ms]
    if (since_poll_.elapsed() > kLate) {
      showNothing("no answer for " + std::to_string(since_poll_.elapsed() / 1000) + " s");
    }
    return;
  }
  since_poll_.start();
  Inspect::Request request;
  request.name = selection_.name();
  requests_.call<Inspect>("inspect", request, [this, name = request.name](const Inspect::Response& state) {
    since_poll_.invalidate();
    showState(name, state);
  });
}

void RunPanel::showState(const std::string& name, const Inspect::Response& state) {
  const bool is_there = !state.state.empty();
  widgets_.play->setEnabled(is_there);
  widgets_.step->setEnabled(state.state == "paused");
  widgets_.reset->setEnabled(is_there);
  widgets_.pace->setEnabled(is_there);
  if (state.stamp.isZero()) {  // the space could not be inspected
    showNothing((is_there ? state.state + ": " : "") + state.message);
    return;
  }
  showRun(state);
  if (name == selection_.name()) {  // otherwise the selection has changed since the request
    showEntity(state);
  }
}

void RunPanel::showNothing(const std::string& reason) {
  speed_.restart();
  widgets_.run->setText(text(reason));
  widgets_.entity->clear();
  widgets_.devices->showDevices({});
}

void RunPanel::showRun(const Inspect::Response& state) {
  is_going_ = state.state == "running" || state.state == "stepping";
  widgets_.play->setIcon(style()->standardIcon(is_going_ ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  widgets_.play->setToolTip(is_going_ ? "pause" : "resume");
  if (!widgets_.pace->view()->isVisible()) {  // an open list must not change under the user
    choosePace(*widgets_.pace, state.target_real_time_factor);
  }
  QString line =
      QString("%1, tick %2, %3 s").arg(text(state.state)).arg(state.tick).arg(state.stamp.toSec(), 0, 'f', 2);
  if (is_going_) {
    const double speed = speed_.look(static_cast<double>(since_start_.elapsed()) / 1000.0, state.stamp.toSec());
    constexpr double kWhole = 10.0;  // no decimals from here on
    line += QString(", %1 x real time").arg(speed, 0, 'f', speed < kWhole ? 2 : 0);
  } else {
    speed_.restart();
  }
  widgets_.run->setText(line);
}

void RunPanel::showEntity(const Inspect::Response& state) {
  if (state.name.empty()) {
    widgets_.entity->setText(text(state.message));
  } else {
    widgets_.entity->setText(describe(state));
  }
  widgets_.devices->showDevices(state.devices);
}

void RunPanel::say(const std::string& message, bool is_refusal) {
  widgets_.answer->setStyleSheet(is_refusal ? "color: #b00000" : "");
  widgets_.answer->setText(text(message));
}

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::RunPanel, rviz::Panel)
