/// The parameters of one engine that may change while the experiment runs, for clients of dynamic_reconfigure:
/// ~parameter_descriptions, ~parameter_updates, ~set_parameters in the namespace of the engine's nodelet.
///
/// The parameters come from the engine's own description at run time, so engines of other packages have them too. A
/// request is one intervention: it takes effect at the next tick boundary, as a whole or not at all. If it is refused
/// the service fails with the reason, which is also the value of `last_error` until the next request.
#pragma once

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/node_handle.h>

#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class EngineParameters {
 public:
  /// @param own the engine's namespace; its queue is served by several threads
  /// @param live parameters of the engine that may change
  EngineParameters(ros::NodeHandle own, const std::string& engine, std::vector<Parameter> live,
                   SimulationThread& thread);

 private:
  bool set(dynamic_reconfigure::Reconfigure::Request& request, dynamic_reconfigure::Reconfigure::Response& response);
  /// Publishes changes to clients, including those that were not made through this service, such as by a reset.
  void publishChanges();
  NamedValues valuesNow() const;

  std::string engine_;
  std::vector<Parameter> live_;
  SimulationThread& thread_;
  ros::Publisher descriptions_;
  ros::Publisher updates_;
  ros::ServiceServer server_;
  ros::WallTimer timer_;
  std::mutex mutex_;  // guards the members below, which are the published values
  std::string last_error_;
  NamedValues published_values_;
  std::optional<std::string> published_error_;  // empty: none has been published yet
};

/// Returns the live parameters of the experiment's engines, by engine; engines without any are left out.
std::vector<std::pair<std::string, std::vector<Parameter>>> liveParameters(const Experiment& experiment);

}  // namespace swarmanoid
