/// The panel "Run" of rviz (thesis 3.6.3): pauses, steps, resets and paces a run, and shows the selected entity with
/// all that its devices say.
///
/// It asks the space by the service `inspect` five times a second while it is in sight, and subscribes to nothing of
/// it.
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

  /// Keys of the window from then on: Ctrl and a digit recall a place of the camera, with Alt they keep one.
  void onInitialize() override;

  /// `Space` of the layout is the name of the space's node, "/space" unless given.
  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void connectWidgets();
  void addShortcut(QWidget* window, int key, const std::function<void()>& act);
  void poll();
  void resumeOrPause();
  void reset();
  /// @param name of the entity that was asked for
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
  QElapsedTimer since_poll_;                    // valid while an answer is under way
  bool is_going_ = false;                       // as of the last answer: it runs, or makes a step
  std::uint64_t requests_made_ = 0;             // of those whose answers are shown the last one counts
  std::vector<QPointer<QShortcut>> shortcuts_;  // the window owns them, and may end before the panel
  SpeedMeter speed_;
  QElapsedTimer since_start_;    // of the panel
  Requests requests_{"/space"};  // last: answers speak of the others
};

}  // namespace swarmanoid
