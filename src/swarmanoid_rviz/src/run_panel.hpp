/// The panel "Run" of rviz (thesis 3.6.3): pauses, steps, resets and paces a run, and shows the selected entity with
/// all readings of its devices.
///
/// While visible it calls the service `inspect` of the space five times a second; it subscribes to no topic of the
/// space.
#pragma once

#include <rviz/panel.h>
#include <swarmanoid_msgs/Inspect.h>

#include <QElapsedTimer>
#include <QPointer>
#include <QShortcut>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <vector>

#include "requests.hpp"
#include "run_panel_widgets.hpp"
#include "selection.hpp"
#include "speed_meter.hpp"

namespace swarmanoid {

class RunPanel : public rviz::Panel {
  Q_OBJECT
 public:
  explicit RunPanel(QWidget* parent = nullptr);
  ~RunPanel() override;
  RunPanel(const RunPanel&) = delete;
  RunPanel& operator=(const RunPanel&) = delete;

  /// Installs keys of the window: Ctrl and a digit recall a viewpoint, Ctrl, Alt and a digit store one.
  void onInitialize() override;

  /// Reads `Space` from the layout: the name of the space's node, by default "/space".
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void connectWidgets();
  void addShortcut(QWidget* window, int key, const std::function<void()>& act);
  void poll();
  void resumeOrPause();
  void reset();
  /// @param name of the requested entity
  void showState(const std::string& name, const swarmanoid_msgs::Inspect::Response& state);
  void showNothing(const std::string& reason);
  void showRun(const swarmanoid_msgs::Inspect::Response& state);
  void showEntity(const swarmanoid_msgs::Inspect::Response& state);
  /// Calls a service and shows its answer.
  template <class Service>
  void ask(const std::string& service, const typename Service::Request& request);
  void say(const std::string& message, bool is_refusal);

  RunPanelWidgets widgets_;
  Selection selection_;
  QTimer timer_;
  QElapsedTimer since_poll_;                    // valid while an answer is pending
  bool is_going_ = false;                       // as of the last answer: the run is running or stepping
  std::uint64_t requests_made_ = 0;             // only the answer to the last one is shown
  std::vector<QPointer<QShortcut>> shortcuts_;  // owned by the window, which may be destroyed before the panel
  SpeedMeter speed_;
  QElapsedTimer since_start_;    // time since the start of the panel
  Requests requests_{"/space"};  // last: its answers use the other members
};

}  // namespace swarmanoid
