/// Publishes the state of the space. It is an observer like any other: it reads the space, and changes nothing.
///
/// Nothing is serialised for a topic without subscribers, except /clock, which is small, and latched topics, whose
/// subscribers may connect later. A subscriber that connects while the space is paused gets the present state at once,
/// and no other subscriber does. Changes from outside between two ticks are shown at once, too. A transform must not be
/// sent twice with one stamp, so the transforms in both cases have stamps that are some nanoseconds later than that of
/// the tick.
#pragma once

#include <ros/node_handle.h>
#include <swarmanoid_msgs/RunResult.h>

#include <cstdint>
#include <functional>
#include <mutex>

#include "pace.hpp"
#include "performance_meter.hpp"
#include "space_options.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid {

class SpaceDisplay final : public Observer {
 public:
  using State = SimulationThread::State;

  /// @param own handle in the namespace of ~world_state and the other topics; /clock and /tf are global
  /// @param drawn_robots robots whose devices are drawn
  SpaceDisplay(const ros::NodeHandle& own, const SpaceOptions& options, DrawnRobots drawn_robots);

  /// Shows this simulation, whose ticks are timed from now on.
  void follow(Simulation& simulation) {
    simulation.timePhases();
    simulation_ = &simulation;
  }
  /// @param thread serves new subscribers between its ticks, once it exists
  void serveNewcomers(SimulationThread* thread);
  /// Publishes all topics that are not up to date, independent of the rates.
  void publishAll();
  /// Publishes the result at the end of a run.
  void publish(const swarmanoid_msgs::RunResult& result) { result_publisher_.publish(result); }
  /// Ends publishing.
  void shutdown();

  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override;

  /// Returns the means over about the last second.
  swarmanoid_msgs::Performance performance() const;
  /// Returns the wall time in which this run made its ticks [s].
  double wallTime() const { return wall_s_; }

 private:
  struct Moment {
    std::uint64_t run = ~std::uint64_t{0};
    std::uint64_t tick = 0;
    bool operator!=(const Moment& other) const { return run != other.run || tick != other.tick; }
  };
  /// The state between two ticks.
  struct Rest {
    Moment moment;
    std::uint64_t state_hash = 0;
    std::int32_t changes = 0;  ///< number of changes shown since the tick
  };
  using Serve = std::function<void(const Space&, const ros::SingleSubscriberPublisher&)>;

  template <class Message>
  ros::Publisher advertise(const std::string& topic, std::uint32_t queue, const Serve& serve);
  /// @return whether the state was changed from outside since it was shown
  bool takeRest(const Space& space);
  void publishClock(const Space& space);
  /// @param delay of the stamp [ns]
  void publishTransforms(const Space& space, std::int32_t delay);
  void publishMarkers(const Space& space);
  /// Valid until the next call.
  const visualization_msgs::MarkerArray& drawDevices(const Space& space);
  void publishWorldState(const Space& space);
  /// @return whether entities were added, removed or placed elsewhere
  bool publishFixed(const Space& space);
  void publishEvents(const Space& space);
  void publishInterventions(const Space& space);
  void measure(const Space& space, Pace::Clock::time_point now);

  ros::NodeHandle own_;
  const Simulation* simulation_ = nullptr;
  std::mutex thread_mutex_;
  SimulationThread* thread_ = nullptr;

  Pace clock_pace_;
  Pace transforms_pace_;
  Pace markers_pace_;
  Pace world_state_pace_;
  Moment clock_moment_;
  Moment transforms_moment_;
  Moment markers_moment_;
  Moment world_state_moment_;
  Rest rest_;
  Transforms transforms_;
  MovingMarkers markers_;
  DeviceDrawings device_drawings_;
  visualization_msgs::MarkerArray device_markers_;
  OutsideChanges changes_;
  swarmanoid_msgs::WorldState world_state_;
  PerformanceMeter meter_;
  Pace::Clock::time_point last_draw_ = Pace::Clock::now();
  std::uint64_t timed_run_ = 0;
  double wall_s_ = 0.0;
  mutable std::mutex performance_mutex_;
  swarmanoid_msgs::Performance performance_;

  ros::Publisher clock_publisher_;
  ros::Publisher tf_publisher_;
  ros::Publisher tf_static_publisher_;
  ros::Publisher world_state_publisher_;
  ros::Publisher performance_publisher_;
  ros::Publisher events_publisher_;
  ros::Publisher interventions_publisher_;
  ros::Publisher markers_publisher_;
  ros::Publisher markers_static_publisher_;
  ros::Publisher engine_markers_publisher_;
  ros::Publisher device_markers_publisher_;
  ros::Publisher result_publisher_;
};

}  // namespace swarmanoid
